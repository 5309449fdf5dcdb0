package org.dfra.drivers.laser.lms;

import java.util.Optional;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;

/**
 * The layout of a sample's sixteen bits: the lowest are the distance, the others are field flags or
 * the intensity. This type has only the number of distance bits.
 *
 * @param code as in the laser's configuration: 0 to 6, or 15
 * @param bits of the distance, 13 to 16
 */
public record MeasuringMode(int code, int bits) {

  /** The factory setting. */
  static final MeasuringMode DEFAULT = new MeasuringMode(0, 13);

  /** Maximum range of the laser, metres. */
  private static final double FARTHEST = 80;

  /** Number of the highest values that are not distances. */
  private static final int RESERVED = 8;

  /** The mode of this code; empty where the telegram listing has none. */
  public static Optional<MeasuringMode> of(int code) {
    return switch (code) {
      case 0, 1, 2 -> Optional.of(new MeasuringMode(code, 13));
      case 3, 4 -> Optional.of(new MeasuringMode(code, 14));
      case 5, 6 -> Optional.of(new MeasuringMode(code, 15));
      case 15 -> Optional.of(new MeasuringMode(code, 16));
      default -> Optional.empty();
    };
  }

  /** Maximum value of the distance bits. */
  public int top() {
    return (1 << bits) - 1;
  }

  /** Maximum distance that can be represented in this unit, metres. */
  public double maxRange(LmsUnit unit) {
    return Math.min(FARTHEST, (top() - RESERVED - 1) * unit.metres());
  }

  /**
   * The distance of a sample in metres; +∞ where the laser reports that it exceeds its range, NaN
   * where it reports that it could not measure (dazzled, too weak a signal, a channel's error,
   * invalid).
   */
  public float range(int sample, LmsUnit unit) {
    int value = sample & top();
    int fromTop = top() - value;
    if (fromTop > RESERVED) {
      return (float) (value * unit.metres());
    }
    return fromTop == RESERVED ? Float.POSITIVE_INFINITY : Float.NaN;
  }

  /** {@code mode 0, 13 bits}. */
  public String inWords() {
    return "mode " + code + ", " + bits + " bits";
  }
}
