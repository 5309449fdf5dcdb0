package org.dfra.drivers.gps.m12;

import org.dfra.flow.sensor.GpsFix;

/**
 * The receiver status word of the twelve-channel messages.
 *
 * @param bits the raw word, 16 bits
 */
public record ReceiverStatus(int bits) {

  /** The receiver's state, bits 15 to 13. */
  public enum State {
    /** Not used by the protocol. */
    RESERVED_0("in a state the protocol does not name"),
    /** Not used by the protocol. */
    RESERVED_1("in a state the protocol does not name"),
    /** The satellites are too close together for a position. */
    BAD_GEOMETRY("tracking satellites that are too close together"),
    /** Searching for satellites. */
    ACQUIRING("acquiring satellites"),
    /** The position is held and only time is solved for. */
    POSITION_HOLD("holding its position"),
    /** The position is an extrapolation of the last one. */
    PROPAGATE("propagating its last position"),
    /** Latitude and longitude are solved for. */
    FIX_2D("giving a 2-D fix"),
    /** Latitude, longitude and height are solved for. */
    FIX_3D("giving a 3-D fix");

    private static final State[] BY_BITS = values();

    private final String words;

    State(String words) {
      this.words = words;
    }

    /** The state, completing the sentence "the receiver is …". */
    public String inWords() {
      return words;
    }

    /** The same, with the numbers of tracked and visible satellites. */
    String inWords(int tracked, int visible) {
      return words + ", " + tracked + " of " + visible + " tracked";
    }
  }

  /** State of the antenna, bits 2 and 1. */
  public enum Antenna {
    /** Connected, and it draws the right current. */
    OK,
    /** It draws too much current: a short circuit. */
    OVER_CURRENT,
    /** It draws too little current: not connected, or passive. */
    UNDER_CURRENT,
    /** The receiver cannot supply its voltage. */
    NO_VOLTAGE;

    private static final Antenna[] BY_BITS = values();

    static Antenna of(int bits) {
      return BY_BITS[bits & 3];
    }
  }

  /** The receiver's state. */
  public State state() {
    return State.BY_BITS[bits >> 13 & 7];
  }

  /** What was solved for. */
  GpsFix.Mode mode() {
    return switch (state()) {
      case FIX_3D -> GpsFix.Mode.FIX_3D;
      case FIX_2D -> GpsFix.Mode.FIX_2D;
      case POSITION_HOLD -> GpsFix.Mode.POSITION_HOLD;
      case RESERVED_0, RESERVED_1, BAD_GEOMETRY, ACQUIRING, PROPAGATE -> GpsFix.Mode.NONE;
    };
  }

  /** The receiver's state and its numbers of satellites, as human-readable text. */
  String inWords(int tracked, int visible) {
    String words = state().inWords(tracked, visible);
    return antenna() == Antenna.OK ? words : words + ", antenna " + antenna();
  }

  /** State of the antenna. */
  public Antenna antenna() {
    return Antenna.of(bits >> 1);
  }

  /** Bit 10: tracking with narrow bandwidth. */
  public boolean narrowBand() {
    return bit(10);
  }

  /** Bit 9: acquiring by the fast method. */
  public boolean fastAcquisition() {
    return bit(9);
  }

  /** Bit 8: the position filter was reset to the raw solution. */
  public boolean filterReset() {
    return bit(8);
  }

  /** Bit 7: started without almanac, time or position. */
  public boolean coldStart() {
    return bit(7);
  }

  /** Bit 6: the fix is differential. */
  public boolean differential() {
    return bit(6);
  }

  /** Bit 5: the position is locked. */
  public boolean positionLock() {
    return bit(5);
  }

  /** Bit 4: surveying its own position. */
  public boolean autosurvey() {
    return bit(4);
  }

  /** Bit 3: too few satellites are visible. */
  public boolean tooFewSatellites() {
    return bit(3);
  }

  private boolean bit(int number) {
    return (bits >> number & 1) != 0;
  }
}
