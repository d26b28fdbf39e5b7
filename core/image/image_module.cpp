/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The only file that knows OpenImageIO. No exception leaves it. */
#include "image/module.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace
{

void explain(char *reason, const std::string &text)
{
    std::snprintf(reason, DUCT_IMAGE_REASON_SIZE, "%s", text.empty() ? "unknown reason" : text.c_str());
}

/* Calls `work` and turns whatever it throws into a sentence and `failed`. */
template <typename Result, typename Work> Result guarded(char *reason, Result failed, Work work)
{
    try {
        return work();
    } catch (const std::bad_alloc &) {
        explain(reason, "out of memory");
    } catch (const std::exception &problem) {
        explain(reason, problem.what());
    } catch (...) {
        explain(reason, "unknown reason");
    }
    return failed;
}

double resolution_of(const OIIO::ImageSpec &spec)
{
    double x = spec.get_float_attribute("XResolution", 0);
    std::string unit = spec.get_string_attribute("ResolutionUnit", "in");
    if (!(x > 0) || !std::isfinite(x) || unit == "none") {
        return 0;
    }
    if (unit == "cm") {
        return x * 2.54;
    }
    return unit == "m" ? x * 0.0254 : x;
}

duct_image_encoding encoding_of(const OIIO::ImageSpec &spec)
{
    std::string space = spec.get_string_attribute("oiio:ColorSpace", "sRGB");
    return space.find("inear") != std::string::npos || space == "lin_srgb" ? DUCT_IMAGE_LINEAR
                                                                           : DUCT_IMAGE_SRGB;
}

struct reader {
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
};

void *open_read(const char *path, duct_image_facts *facts, char *reason)
{
    return guarded<void *>(reason, nullptr, [&]() -> void * {
        OIIO::ImageSpec wish;
        wish.attribute("oiio:UnassociatedAlpha", 1);
        auto self = std::make_unique<reader>();
        self->input = OIIO::ImageInput::open(path, &wish);
        if (!self->input) {
            explain(reason, OIIO::geterror());
            return nullptr;
        }
        self->spec = self->input->spec();
        const OIIO::ImageSpec &spec = self->spec;
        if (spec.deep || spec.nchannels < 1 || spec.depth > 1) {
            explain(reason, "is not a flat picture");
            return nullptr;
        }
        bool alpha = spec.alpha_channel >= 0 && spec.alpha_channel < spec.nchannels;
        *facts = duct_image_facts{spec.width,
                                  spec.height,
                                  alpha ? 4 : 3,
                                  alpha && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0,
                                  encoding_of(spec),
                                  resolution_of(spec),
                                  0};
        return self.release();
    });
}

int read_pixels(void *handle, float *pixels, char *reason)
{
    return guarded<int>(reason, 0, [&]() -> int {
        auto *self = static_cast<reader *>(handle);
        const OIIO::ImageSpec &spec = self->spec;
        const auto channels = static_cast<std::size_t>(spec.nchannels);
        const auto width = static_cast<std::size_t>(spec.width);
        const int alpha = spec.alpha_channel;
        const std::size_t colours = channels - (alpha >= 0 ? 1 : 0);
        /* Some rows at a time: a multiple of the tile height, which tiled files are read by. */
        const int rows = spec.tile_height > 1 ? spec.tile_height : 16;
        std::vector<float> strip(width * channels * static_cast<std::size_t>(rows));
        for (int y = 0; y < spec.height; y += rows) {
            const int end = std::min(y + rows, spec.height);
            const bool done =
                spec.tile_width > 0
                    ? self->input->read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + y, spec.y + end,
                                              spec.z, spec.z + 1, 0, spec.nchannels, OIIO::TypeDesc::FLOAT,
                                              strip.data())
                    : self->input->read_scanlines(0, 0, spec.y + y, spec.y + end, spec.z, 0, spec.nchannels,
                                                  OIIO::TypeDesc::FLOAT, strip.data());
            if (!done) {
                explain(reason, self->input->geterror());
                return 0;
            }
            const std::size_t count = width * static_cast<std::size_t>(end - y);
            float *out = pixels + static_cast<std::size_t>(y) * width * 4;
            for (std::size_t i = 0; i < count; i++, out += 4) {
                const float *in = strip.data() + i * channels;
                std::size_t next = 0;
                for (std::size_t k = 0; k < 3; k++) {
                    if (k == 0 || colours >= 3) {
                        next += static_cast<int>(next) == alpha ? 1 : 0;
                        out[k] = next < channels ? in[next++] : 0.0f;
                    } else {
                        out[k] = out[0];
                    }
                }
                out[3] = alpha >= 0 ? in[alpha] : 1.0f;
            }
        }
        return 1;
    });
}

void close_read(void *handle)
{
    char reason[DUCT_IMAGE_REASON_SIZE];
    guarded<int>(reason, 0, [&]() -> int {
        std::unique_ptr<reader> self(static_cast<reader *>(handle));
        return self->input->close() ? 1 : 0;
    });
}

OIIO::TypeDesc type_of(const duct_image_facts &facts)
{
    if (facts.encoding == DUCT_IMAGE_LINEAR) {
        return facts.bits == 32 ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::HALF;
    }
    return facts.bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
}

void *open_write(const char *path, const duct_image_facts *facts, char *reason)
{
    return guarded<void *>(reason, nullptr, [&]() -> void * {
        auto output = OIIO::ImageOutput::create(path);
        if (!output) {
            explain(reason, OIIO::geterror());
            return nullptr;
        }
        OIIO::ImageSpec spec(facts->width, facts->height, facts->channels, type_of(*facts));
        if (facts->channels == 4) {
            spec.alpha_channel = 3;
        }
        if (!facts->premultiplied) {
            spec.attribute("oiio:UnassociatedAlpha", 1);
        }
        spec.attribute("oiio:ColorSpace", facts->encoding == DUCT_IMAGE_LINEAR ? "Linear" : "sRGB");
        spec.attribute("compression", "zip");
        spec.attribute("Software", "Ductus");
        if (std::strcmp(output->format_name(), "png") != 0) {
            /* OpenImageIO would write the time of day, and the same picture has to give the same bytes. PNG
             * has no time unless asked for. */
            spec.attribute("DateTime", "2000:01:01 00:00:00");
        }
        if (facts->resolution > 0) {
            spec.attribute("XResolution", static_cast<float>(facts->resolution));
            spec.attribute("YResolution", static_cast<float>(facts->resolution));
            spec.attribute("ResolutionUnit", "in");
        }
        if (!output->open(path, spec)) {
            explain(reason, output->geterror());
            return nullptr;
        }
        return output.release();
    });
}

int write_row(void *handle, int y, const float *row, char *reason)
{
    return guarded<int>(reason, 0, [&]() -> int {
        auto *output = static_cast<OIIO::ImageOutput *>(handle);
        if (!output->write_scanline(y, 0, OIIO::TypeDesc::FLOAT, row)) {
            explain(reason, output->geterror());
            return 0;
        }
        return 1;
    });
}

int close_write(void *handle, int keep, char *reason)
{
    return guarded<int>(reason, 0, [&]() -> int {
        std::unique_ptr<OIIO::ImageOutput> output(static_cast<OIIO::ImageOutput *>(handle));
        if (!output->close() && keep != 0) {
            explain(reason, output->geterror());
            return 0;
        }
        return 1;
    });
}

const duct_image_module functions = {
    DUCT_IMAGE_MODULE_VERSION, open_read, read_pixels, close_read, open_write, write_row, close_write};

} // namespace

extern "C" __attribute__((visibility("default"))) const duct_image_module *duct_image_module_get(void);

const duct_image_module *duct_image_module_get(void)
{
    return &functions;
}
