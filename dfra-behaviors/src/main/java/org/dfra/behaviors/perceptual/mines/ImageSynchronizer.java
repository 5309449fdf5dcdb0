package org.dfra.behaviors.perceptual.mines;

import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;

/**
 * Pairs visible and thermal images that were taken at about the same time. An image waits for its
 * partner while the other camera sends images; the synchronizer stops waiting for a camera that
 * sends none. Confined to one thread.
 *
 * @param <T> data attached to an image
 */
final class ImageSynchronizer<T> {

  private static final Duration TOGETHER = Duration.ofMillis(150);
  private static final Duration SILENT = Duration.ofSeconds(2);

  private final Map<Band, TaggedImage<T>> waiting = new EnumMap<>(Band.class);
  private final Map<Band, CameraImage> last = new EnumMap<>(Band.class);

  /** An image with its attached data. */
  record TaggedImage<T>(CameraImage image, T tag) {}

  /** Adds an image; returns the completed group: two images, one, or none. */
  List<TaggedImage<T>> add(CameraImage image, T with) {
    Band other = image.band() == Band.VISIBLE ? Band.THERMAL : Band.VISIBLE;
    TaggedImage<T> taken = new TaggedImage<>(image, with);
    last.put(image.band(), image);
    waiting.put(image.band(), taken);
    TaggedImage<T> partner = waiting.get(other);
    if (partner != null && isWithin(image, partner.image(), TOGETHER)) {
      waiting.clear();
      return image.band() == Band.VISIBLE ? List.of(taken, partner) : List.of(partner, taken);
    }
    CameraImage others = last.get(other);
    if (others == null || !isWithin(image, others, SILENT)) {
      waiting.clear();
      return List.of(taken);
    }
    return new ArrayList<>();
  }

  private static boolean isWithin(CameraImage one, CameraImage other, Duration most) {
    return Duration.between(one.measured(), other.measured()).abs().compareTo(most) <= 0;
  }
}
