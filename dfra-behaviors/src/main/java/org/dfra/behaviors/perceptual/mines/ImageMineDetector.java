package org.dfra.behaviors.perceptual.mines;

import java.util.Optional;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.geometry.Transform;
import org.jspecify.annotations.Nullable;

/**
 * Searches the images of one camera for mine-like objects. It depends on no time and stores no
 * image, only the camera's geometry. Confined to one thread.
 */
public final class ImageMineDetector {

  private final ImageMineDetectorSettings settings;
  private final Contrast heat;
  private final Contrast light;
  private @Nullable WindowGrid windows; // of the last image's camera

  /** For a camera that has not sent an image yet. */
  public ImageMineDetector(ImageMineDetectorSettings settings) {
    this.settings = settings;
    this.heat = new HeatContrast(settings.minThermalContrast());
    this.light =
        new LightContrast(
            settings.target(), settings.minVisibleContrast(), settings.colourTolerance());
  }

  /**
   * Searches an image.
   *
   * @param mount of the camera on the base, whose x is forward and whose z is 0 on the ground
   * @return empty if the image cannot be decoded
   */
  public Optional<ImageDetections> detect(CameraImage image, Transform mount) {
    PinholeCamera camera =
        new PinholeCamera(mount, image.width(), image.height(), image.focalLength());
    WindowGrid known = windows;
    WindowGrid now =
        known != null && known.camera().equals(camera)
            ? known
            : new WindowGrid(
                camera, settings.target(), settings.minDistance(), settings.maxDistance());
    windows = now;
    Contrast contrast = image.band() == Band.THERMAL ? heat : light;
    return DecodedImage.decode(image)
        .map(
            picture ->
                new ImageDetections(
                    image.band(),
                    now,
                    ContrastPeakFinder.find(picture, now, contrast).stream()
                        .map(ContrastPeakFinder.Peak::spot)
                        .toList()));
  }
}
