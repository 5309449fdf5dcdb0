package org.dfra.drivers.laser.lms;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.Optional;

/**
 * The laser's configuration, which it keeps in its flash memory. Only two of its bytes are used
 * here; the others, which configure its switching outputs, are written back unchanged.
 */
public final class LmsConfiguration {

  /** Minimum length, bytes. */
  static final int SHORTEST = 8;

  /** Maximum length, bytes. */
  static final int LONGEST = 40;

  private static final int MODE_AT = 5;
  private static final int UNIT_AT = 6;

  private final byte[] bytes;

  /**
   * @param bytes as the laser reports them, {@value #SHORTEST} to {@value #LONGEST}
   */
  LmsConfiguration(byte[] bytes) {
    this.bytes = bytes.clone();
  }

  /** The bytes, in the laser's format. */
  byte[] bytes() {
    return bytes.clone();
  }

  /** Its measuring mode, which defines the distance bits of a sample; empty for an unknown mode. */
  public Optional<MeasuringMode> mode() {
    return MeasuringMode.of(modeCode());
  }

  /** The code of its measuring mode, 0 to 255. */
  public int modeCode() {
    return bytes[MODE_AT] & 0xFF;
  }

  /** Its unit of distance; empty for an unknown unit. */
  public Optional<LmsUnit> unit() {
    int code = bytes[UNIT_AT] & 0xFF;
    return code < LmsUnit.values().length ? Optional.of(LmsUnit.values()[code]) : Optional.empty();
  }

  /** A copy with another measuring mode. */
  LmsConfiguration with(MeasuringMode mode) {
    return with(MODE_AT, mode.code());
  }

  /** A copy with another unit. */
  LmsConfiguration with(LmsUnit unit) {
    return with(UNIT_AT, unit.ordinal());
  }

  private LmsConfiguration with(int at, int value) {
    LmsConfiguration changed = new LmsConfiguration(bytes);
    changed.bytes[at] = (byte) value;
    return changed;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof LmsConfiguration that && Arrays.equals(bytes, that.bytes);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(bytes);
  }

  @Override
  public String toString() {
    return "LmsConfiguration[" + HexFormat.of().formatHex(bytes) + "]";
  }

  /** Units of the laser's distances; in the order of the two bits in a scan. */
  public enum LmsUnit {
    /** Centimetres. */
    CM(0.01, 0.01),
    /** Millimetres. */
    MM(0.001, 0.005),
    /** Decimetres. */
    DM(0.1, 0.1);

    private final double metres;
    private final double accuracy;

    LmsUnit(double metres, double accuracy) {
      this.metres = metres;
      this.accuracy = accuracy;
    }

    /** The unit in metres. */
    public double metres() {
      return metres;
    }

    /**
     * Accuracy of a distance in this unit, one sigma, metres: the laser's, or the unit if that is
     * larger.
     */
    public double accuracy() {
      return accuracy;
    }

    /** {@code mm}. */
    public String word() {
      return name().toLowerCase(java.util.Locale.ROOT);
    }
  }
}
