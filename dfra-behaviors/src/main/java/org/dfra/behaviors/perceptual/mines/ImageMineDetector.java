package org.dfra.behaviors.perceptual.mines;

import java.util.List;
import java.util.Optional;
import org.dfra.behaviors.perceptual.mines.Contrast.BlobScore;
import org.dfra.behaviors.perceptual.mines.Contrast.LightContrast;
import org.dfra.behaviors.perceptual.mines.DecodedImage.SummedTable;
import org.dfra.behaviors.perceptual.mines.DetectionWindow.PixelRect;
import org.dfra.behaviors.perceptual.mines.DetectionWindow.WindowGrid;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
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
            decoded ->
                new ImageDetections(
                    image.band(),
                    now,
                    ContrastPeakFinder.find(decoded, now, contrast).stream()
                        .map(ContrastPeakFinder.Peak::spot)
                        .toList()));
  }

  /**
   * A mine is warmer than its surroundings on all sides, or colder on all sides. A strip of shadow
   * is not: it continues on at least one side.
   *
   * @param minContrast minimum difference of the mine from its most similar side, kelvin
   */
  private record HeatContrast(double minContrast) implements Contrast {

    private static final double PER_KELVIN = 100;

    @Override
    public double score(DecodedImage image, DetectionWindow window) {
      SummedTable heat = image.channels().get(0);
      double inside = heat.mean(window.inside());
      BlobScore warmer = new BlobScore();
      BlobScore colder = new BlobScore();
      for (PixelRect box : window.surroundings()) {
        double difference = (inside - heat.mean(box)) / PER_KELVIN;
        warmer.add(difference);
        colder.add(-difference);
      }
      return Math.max(warmer.score(minContrast), colder.score(minContrast));
    }
  }

  /** Detections in one image of one camera. Immutable. */
  public static final class ImageDetections {

    private final Band band;
    private final WindowGrid windows;
    private final List<GroundPoint> found;

    ImageDetections(Band band, WindowGrid windows, List<GroundPoint> found) {
      this.band = band;
      this.windows = windows;
      this.found = List.copyOf(found);
    }

    /** The image's spectral band. */
    public Band band() {
      return band;
    }

    /** Positions of mine-like objects, the strongest first; x forward of the robot's base. */
    public List<GroundPoint> points() {
      return found;
    }

    /** Whether a mine there would be visible. */
    public boolean covers(GroundPoint spot) {
      return windows.covers(spot);
    }
  }
}
