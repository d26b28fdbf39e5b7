# SPDX-License-Identifier: GPL-3.0-or-later
"""An operator for each operation of the core, made from its table; and those of the add-on itself."""

import threading
import traceback

import bpy

from . import binding, gather, grease_pencil, properties
from .own import OWN


def operator_name(operation):
    return "ductus." + operation.id.replace("-", "_")


def settings_name(operation):
    """The name of the operation's group in scene.ductus."""
    return operation.id.replace("-", "_")


class _Run:
    """One run of an operation: gathered and written in Blender's thread, computed in that or another."""

    def __init__(self, context, operation, group):
        from .job import Job

        self.host = grease_pencil.generation()
        ductus = binding.ductus()
        own = properties.own_values(group)
        self.settings = ductus.Settings(operation.id)
        for param in operation.params:
            found = properties.value(group, param)
            if param.type == "hand" and not found:
                raise grease_pencil.Refused(f"no {param.label.lower()} is chosen: choose one in the panel")
            self.settings[param.id] = found
        self.work = gather.gather(context, self.host, own)
        self.job = Job(self.work.parts, own, self.work.method)
        self.fraction, self.stop = 0.0, False

    def compute(self, tell=None):
        ductus = binding.ductus()

        def progress(fraction):
            self.fraction = fraction
            if tell is not None:
                tell(fraction)
            return not self.stop

        def run(fill, progress):
            drawing = ductus.Drawing()
            fill(drawing)
            return ductus.run(self.settings, drawing, progress)

        self.job.compute(run, progress)

    def write(self):
        return gather.write(self.host, self.work, self.job)


class _Operate:
    """What the operators of all operations share. A subclass has `operation` and its properties."""

    bl_options = {"REGISTER", "UNDO", "PRESET"}
    operation = None

    @classmethod
    def poll(cls, context):
        # What else is missing is said by a sentence when the operator runs.
        return context.scene is not None

    def _take_scene_settings(self, context):
        """The panel's values: all of them for the panel's button; else where the caller has not given others (Blender
        gives those of the last run by itself)."""
        group = getattr(context.scene.ductus, settings_name(self.operation))
        for name in properties.names(OWN + self.operation.params):
            if self.from_panel or not self.properties.is_property_set(name):
                setattr(self, name, getattr(group, name))

    def _failed(self, error):
        sentence = str(error).strip()
        if isinstance(error, grease_pencil.Refused):
            sentence = sentence[:1].upper() + sentence[1:]
        self.report({"ERROR"}, sentence if sentence.endswith((".", "!", "?")) else sentence + ".")
        return {"CANCELLED"}

    def _unexpected(self, error):
        traceback.print_exception(type(error), error, error.__traceback__)
        return self._failed(f"{self.operation.label} failed and changed nothing: {type(error).__name__}: {error}")

    def execute(self, context):
        manager = context.window_manager
        try:
            run = _Run(context, self.operation, self)
            manager.progress_begin(0, 100)
            try:
                run.compute(lambda fraction: manager.progress_update(int(100 * fraction)))
            finally:
                manager.progress_end()
            return self._finish(context, run)
        except (grease_pencil.Refused, binding.ductus().Error) as error:
            return self._failed(error)
        except Exception as error:  # the user's drawing must not pay for our mistakes
            return self._unexpected(error)

    def _finish(self, context, run):
        lines, drawings = run.write()
        if lines == 0:
            self.report({"INFO"}, "Nothing had to change")
        elif run.job.alike:
            self.report({"WARNING"}, "The lines do not boil: with these settings nothing is left to chance. "
                        "Look for a setting that allows variation")
        else:
            self.report({"INFO"}, f"{lines} line{'s' * (lines != 1)} in {drawings} drawing{'s' * (drawings != 1)}")
        for area in context.screen.areas if context.screen else ():
            if area.type == "VIEW_3D":
                area.tag_redraw()
        return {"FINISHED"}

    # With a window: the core works in a thread of its own, Blender stays awake and Esc cancels.

    def invoke(self, context, event):
        self._take_scene_settings(context)
        if bpy.app.background or context.window is None:
            return self.execute(context)
        try:
            self._run = _Run(context, self.operation, self)
        except (grease_pencil.Refused, binding.ductus().Error) as error:
            return self._failed(error)
        except Exception as error:
            return self._unexpected(error)
        self._error = None
        self._thread = threading.Thread(target=self._work, daemon=True)
        manager = context.window_manager
        manager.progress_begin(0, 100)
        self._timer = manager.event_timer_add(0.05, window=context.window)
        manager.modal_handler_add(self)
        self._thread.start()
        return {"RUNNING_MODAL"}

    def _work(self):
        try:
            self._run.compute()
        except BaseException as error:  # told in Blender's thread
            self._error = error

    def modal(self, context, event):
        if event.type == "ESC":
            self._run.stop = True
        if event.type == "TIMER":
            if self._thread.is_alive():
                percent = int(100 * self._run.fraction)
                context.window_manager.progress_update(percent)
                word = "stopping" if self._run.stop else f"{percent} %    Esc: cancel"
                context.workspace.status_text_set(f"{self.operation.label}: {word}")
                return {"RUNNING_MODAL"}
            return self._end(context)
        # Nothing may change under the run; only the pointer moves.
        return {"RUNNING_MODAL"}

    def _end(self, context):
        self._thread.join()
        self._clean_up(context)
        run, error = self._run, self._error
        self._run = self._thread = self._error = None
        if run.stop or isinstance(error, binding.ductus().Cancelled):
            self.report({"INFO"}, f"{self.operation.label}: cancelled, nothing was changed")
            return {"CANCELLED"}
        if isinstance(error, (grease_pencil.Refused, binding.ductus().Error)):
            return self._failed(error)
        if error is not None:
            return self._unexpected(error)
        try:
            return self._finish(context, run)
        except grease_pencil.Refused as refused:
            return self._failed(refused)
        except Exception as other:
            return self._unexpected(other)

    def _clean_up(self, context):
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)

    def cancel(self, context):
        """Blender closes the window or the file under the run."""
        if getattr(self, "_run", None) is not None:
            self._run.stop = True
            self._thread.join()
            self._clean_up(context)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        common = [param for param in self.operation.params if not param.advanced]
        properties.draw(layout, self, common, False)
        properties.draw(layout, self, OWN, False)
        layout.prop(self, "show_advanced")
        if self.show_advanced:
            properties.draw(layout, self, OWN, True)
            for group in groups(self.operation.params):
                box = layout.box()
                box.label(text=group)
                properties.draw(box, self, [param for param in self.operation.params if param.group == group], True)


def groups(params):
    """The headings of the advanced parameters, in the order of the table."""
    found = []
    for param in params:
        if param.advanced and param.group not in found:
            found.append(param.group)
    return found


def operator_for(operation):
    annotations = properties.annotations(OWN + operation.params)
    annotations["show_advanced"] = bpy.props.BoolProperty(
        name="More", description="Show all settings", default=False, options={"SKIP_SAVE"})
    annotations["from_panel"] = bpy.props.BoolProperty(options={"SKIP_SAVE", "HIDDEN"})
    return type(f"DUCTUS_OT_{settings_name(operation)}", (_Operate, bpy.types.Operator), {
        "__doc__": operation.summary,
        "__annotations__": annotations,
        "__module__": __name__,
        "bl_idname": operator_name(operation),
        "bl_label": operation.label,
        "bl_description": operation.summary.rstrip("."),
        "operation": operation,
    })


class DUCTUS_OT_restore_original(bpy.types.Operator):
    """Show the original of the active layer again and remove the result"""

    bl_idname = "ductus.restore_original"
    bl_label = "Restore Original"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.object is not None

    def execute(self, context):
        try:
            host = grease_pencil.generation()
            ob = context.object
            if ob.type != host.OBJECT_TYPE:
                raise grease_pencil.Refused("The active object is no Grease Pencil object: click on one first")
            count = gather.restore(context, host, ob)
        except grease_pencil.Refused as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if count == 0:
            self.report({"ERROR"}, f"'{ob.name}' has no original to restore: its lines were changed in place, or not "
                        "at all.")
            return {"CANCELLED"}
        self.report({"INFO"}, f"{count} layer{'s' * (count != 1)} restored")
        return {"FINISHED"}


class DUCTUS_OT_choose_file(bpy.types.Operator):
    """Choose a recording or library of your own"""

    bl_idname = "ductus.choose_file"
    bl_label = "Choose a Recording"
    bl_options = {"INTERNAL"}

    filepath: bpy.props.StringProperty(subtype="FILE_PATH")
    group: bpy.props.StringProperty(options={"HIDDEN"})
    setting: bpy.props.StringProperty(options={"HIDDEN"})

    def invoke(self, context, event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        setattr(getattr(context.scene.ductus, self.group), self.setting, self.filepath)
        return {"FINISHED"}


class DUCTUS_OT_table_preset(bpy.types.Operator):
    """Set all values to those of the preset; the hand stays"""

    bl_idname = "ductus.table_preset"
    bl_label = "Preset"
    bl_options = {"REGISTER", "UNDO", "INTERNAL"}

    operation: bpy.props.StringProperty(options={"HIDDEN"})
    preset: bpy.props.StringProperty(options={"HIDDEN"})

    @classmethod
    def description(cls, context, values):
        preset = _find_preset(values.operation, values.preset)[1]
        return preset.tooltip.rstrip(".") if preset else cls.__doc__

    def execute(self, context):
        operation, preset = _find_preset(self.operation, self.preset)
        if preset is None:
            self.report({"ERROR"}, f"There is no preset '{self.preset}'.")
            return {"CANCELLED"}
        group = getattr(context.scene.ductus, settings_name(operation))
        for param in operation.params:
            if param.type != "hand":
                properties.assign(group, param, preset.values.get(param.id, param.default))
        return {"FINISHED"}


def _find_preset(operation_id, preset_id):
    for operation in binding.operations():
        if operation.id == operation_id:
            for preset in operation.presets:
                if preset.id == preset_id:
                    return operation, preset
    return None, None


CLASSES = (DUCTUS_OT_restore_original, DUCTUS_OT_choose_file, DUCTUS_OT_table_preset)
