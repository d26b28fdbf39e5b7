(define (as-text value)
  (let ((port (open-output-string)))
    (display value port)
    (get-output-string port)))

(define (layers image) (car (gimp-image-get-layers image)))
(define (paths image) (car (gimp-image-get-vectors image)))

; An image with one layer, filled with white where it has no alpha, and a path with a curve across it.
(define (make-image width height kind precision layer-kind)
  (let* ((image (car (gimp-image-new-with-precision width height kind precision)))
         (layer (car (gimp-layer-new image width height layer-kind "Paper" 100 LAYER-MODE-NORMAL))))
    (gimp-image-insert-layer image layer 0 0)
    (gimp-context-set-background '(255 255 255))
    (gimp-context-set-foreground '(180 20 20))
    (if (= (car (gimp-drawable-has-alpha layer)) FALSE)
        (gimp-drawable-fill layer FILL-BACKGROUND))
    (gimp-image-clean-all image)
    image))

(define (add-curve image name x0 y0 x1 y1)
  (let* ((path (car (gimp-vectors-new image name)))
         (dx (/ (- x1 x0) 3))
         (dy (/ (- y1 y0) 3)))
    (gimp-vectors-stroke-new-from-points path VECTORS-STROKE-TYPE-BEZIER 12
      (vector x0 y0 x0 y0 (+ x0 dx) (- (+ y0 dy) 30) (- x1 dx) (+ (- y1 dy) 30) x1 y1 x1 y1) FALSE)
    (gimp-image-insert-vectors image path 0 0)
    (gimp-image-clean-all image)
    path))

; The colour at a place of everything visible: a list of red, green, blue in 0..255, sRGB.
(define (colour-at image x y)
  (car (gimp-image-pick-color image (car (gimp-image-get-active-layer image)) x y TRUE FALSE 0)))

; How many pixels of a layer are not transparent, and their mean level.
(define (painted layer)
  (list-ref (gimp-drawable-histogram layer HISTOGRAM-ALPHA 0.02 1) 4))

(define (restyle image drawable settings)
  (plug-in-ductus-restyle-text RUN-NONINTERACTIVE image drawable settings))

(define (active image) (car (gimp-image-get-active-drawable image)))
