package org.dfra.behaviors.perceptual.mines;

import java.util.Optional;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.geometry.Transform;
import org.jspecify.annotations.Nullable;

/**
 * Searches the images of one camera for what looks like a mine. It knows no time and remembers no
 * image, only how the camera stands. Confined to one thread.
 */
public final class Eye {

  private final EyeSettings settings;
  private final Contrast heat;
  private final Contrast light;
  private @Nullable Windows windows; // of the last image's camera

  /** Of a camera that has not told anything yet. */
  public Eye(EyeSettings settings) {
    this.settings = settings;
    this.heat = new HeatContrast(settings.leastHeat());
    this.light = new LightContrast(settings.target(), settings.leastDark(), settings.tolerance());
  }

  /**
   * Searches an image.
   *
   * @param mount of the camera on the base, whose x is forward and whose z is 0 on the ground
   * @return nothing if the image cannot be decoded
   */
  public Optional<Glance> look(CameraImage image, Transform mount) {
    PinHole camera = new PinHole(mount, image.width(), image.height(), image.focalLength());
    Windows known = windows;
    Windows now =
        known != null && known.camera().equals(camera)
            ? known
            : new Windows(camera, settings.target(), settings.near(), settings.far());
    windows = now;
    Contrast contrast = image.band() == Band.THERMAL ? heat : light;
    return Picture.decode(image)
        .map(
            picture ->
                new Glance(
                    image.band(),
                    now,
                    Finder.find(picture, now, contrast).stream().map(Finder.Find::spot).toList()));
  }
}
