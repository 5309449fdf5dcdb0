package org.dfra.drivers.gps.m12;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Position;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Time;

/** A message from a receiver, decoded from one intact frame. */
public sealed interface M12Message
    permits M12PositionMessage,
        M12Message.VisibleSatellites,
        M12Message.TimeRaim,
        M12Message.PositionControl,
        M12Message.PositionHoldMode,
        M12Message.HeldPosition,
        M12Message.ReceiverClock,
        M12Message.M12UtcOffset,
        M12Message.TimeScale,
        M12Message.ReceiverIdentification,
        M12Message.OtherMessage,
        M12Message.MalformedMessage {

  /** The frame's ID: two letters, such as {@code Ha}. */
  String id();

  /**
   * {@code @@As}: the position that is held in position hold; also the acknowledgement of setting
   * it.
   *
   * @param position the position; only its height above the ellipsoid is valid
   */
  record HeldPosition(M12Position position) implements M12Message {

    @Override
    public String id() {
      return "As";
    }
  }

  /**
   * {@code @@Bo}: how far GPS time is ahead of UTC.
   *
   * @param seconds GPS time minus UTC; 0 while the receiver does not know it
   */
  record M12UtcOffset(int seconds) implements M12Message {

    @Override
    public String id() {
      return "Bo";
    }

    /** Whether the receiver knows it. */
    public boolean isKnown() {
      return seconds != 0;
    }
  }

  /**
   * An intact frame with invalid content: its checksum is right, but a value is outside its valid
   * range.
   *
   * @param id the frame's two letters
   * @param reason which value, what it is, and which values are valid
   */
  record MalformedMessage(String id, String reason) implements M12Message {}

  /** An intact frame of an ID that has no decoder (yet). Immutable: the payload is copied. */
  record OtherMessage(String id, byte[] payload) implements M12Message {

    /**
     * @param id the frame's two letters
     * @param payload the bytes after the ID and before the checksum
     */
    public OtherMessage {
      payload = payload.clone();
    }

    @Override
    public byte[] payload() {
      return payload.clone();
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof OtherMessage o
          && id.equals(o.id)
          && Arrays.equals(payload, o.payload);
    }

    @Override
    public int hashCode() {
      return 31 * id.hashCode() + Arrays.hashCode(payload);
    }

    @Override
    public String toString() {
      return "OtherMessage[@@" + id + " " + HexFormat.of().formatHex(payload) + "]";
    }
  }

  /**
   * {@code @@Gd}: what the receiver solves for; also its acknowledgement of the command.
   *
   * @param mode what it solves for
   */
  record PositionControl(Mode mode) implements M12Message {

    /** What a receiver can solve for, in the order of the protocol's numbers. */
    public enum Mode {
      /** Latitude, longitude and height. The only one for a receiver that moves. */
      POSITION_3D,
      /** Time only; the position is held. */
      HOLD,
      /** Latitude and longitude; the height is held. */
      ALTITUDE_HOLD,
      /** Position, averaged for hours and then held. */
      SURVEY;

      /** The word used in configuration: {@code position_3d}. */
      public String word() {
        return name().toLowerCase(Locale.ROOT);
      }
    }

    @Override
    public String id() {
      return "Gd";
    }
  }

  /**
   * {@code @@At}: whether an eight-channel receiver holds its position; also its acknowledgement of
   * the command.
   *
   * @param mode the mode
   */
  record PositionHoldMode(Mode mode) implements M12Message {

    /** The modes of an eight-channel receiver, in the order of the protocol's numbers. */
    public enum Mode {
      /** It solves for its position. */
      OFF,
      /** It holds its position and solves for time only. */
      ON,
      /** It averages its position and holds the result when it has finished. */
      SURVEY
    }

    @Override
    public String id() {
      return "At";
    }
  }

  /**
   * {@code @@Gb}: the receiver's date and time; its answer to a set command and to a query.
   *
   * @param time date and time, in the scale that the receiver is set to
   * @param localOffset offset of local time from UTC, minutes, + is east; reported, not applied
   */
  record ReceiverClock(M12Time time, int localOffset) implements M12Message {

    @Override
    public String id() {
      return "Gb";
    }
  }

  /**
   * {@code @@Aw}: the time scale that the receiver reports; its acknowledgement of the command.
   *
   * @param isUtc whether it is UTC; otherwise GPS time
   */
  record TimeScale(boolean isUtc) implements M12Message {

    @Override
    public String id() {
      return "Aw";
    }
  }

  /**
   * {@code @@Bb}: the satellites above the horizon by the almanac. Source: Motorola Oncore user's
   * guides.
   *
   * @param count their number; may exceed the twelve that are listed
   * @param satellites at most twelve of them
   */
  record VisibleSatellites(int count, List<VisibleSatellite> satellites) implements M12Message {

    /**
     * Direction of a satellite.
     *
     * @param satellite its number, 1 to 37
     * @param doppler shift of its carrier, hertz
     * @param elevation above the horizon, degrees, 0 to 90
     * @param azimuth from true north, clockwise, degrees, 0 to 360
     * @param health the health bits of the almanac; 0 is healthy
     */
    public record VisibleSatellite(
        int satellite, int doppler, int elevation, int azimuth, int health) {}

    public VisibleSatellites {
      satellites = List.copyOf(satellites);
    }

    @Override
    public String id() {
      return "Bb";
    }
  }

  /**
   * {@code @@Hn} and {@code @@En}: whether the satellites agree on the time (time RAIM, receiver
   * autonomous integrity monitoring). Source: Motorola Oncore user's guides; the offsets of
   * solution status and sawtooth are those of the NTP project's drivers.
   *
   * @param id {@code Hn} of twelve channels, {@code En} of eight
   * @param pulse whether the receiver gives its pulse each second
   * @param solution result for the last solution
   * @param ability what can be detected with the satellites in view
   * @param removed satellites removed from the solution, one bit each, the lowest is satellite 1; 0
   *     where the message does not contain it
   * @param accuracy the time solution's accuracy, one sigma, nanoseconds
   * @param sawtooth how much too early the next pulse is, nanoseconds
   */
  record TimeRaim(
      String id,
      boolean pulse,
      Solution solution,
      Ability ability,
      long removed,
      int accuracy,
      int sawtooth)
      implements M12Message {

    /** Result for a solution. */
    public enum Solution {
      /** Within the alarm limit. */
      OK,
      /** Beyond the alarm limit: do not use it. */
      ALARM,
      /** Not known: too few satellites, or time RAIM is off. */
      UNKNOWN
    }

    /** What can be detected with the satellites in view. */
    public enum Ability {
      /** A faulty satellite can be detected and removed. */
      DETECTION_AND_ISOLATION,
      /** A faulty satellite can only be detected. */
      DETECTION,
      /** Neither. */
      NONE
    }

    /** {@code OK, detection and isolation, accuracy 54 ns}. */
    public String inWords() {
      return solution
          + ", "
          + switch (ability) {
            case DETECTION_AND_ISOLATION -> "a wrong satellite would be detected and taken out";
            case DETECTION -> "a wrong satellite would be detected";
            case NONE -> "a wrong satellite would not be detected";
          }
          + ", time accurate to "
          + accuracy
          + " ns";
    }
  }

  /**
   * {@code @@Cj}: the receiver's identification. Texts as received, trimmed; empty where missing.
   * They are found by their labels, because the columns differ between firmwares.
   *
   * @param copyright the first line
   * @param softwarePartNumber {@code SFTW P/N #}
   * @param softwareVersion {@code SOFTWARE VER #}
   * @param softwareRevision {@code SOFTWARE REV #}
   * @param softwareDate {@code SOFTWARE DATE}
   * @param model {@code MODEL #}
   * @param hardwarePartNumber {@code HWDR P/N #}
   * @param serialNumber {@code SERIAL #}
   * @param manufactureDate {@code MANUFACTUR DATE}
   * @param options {@code OPTIONS LIST}, with the lines after it
   */
  record ReceiverIdentification(
      String copyright,
      String softwarePartNumber,
      String softwareVersion,
      String softwareRevision,
      String softwareDate,
      String model,
      String hardwarePartNumber,
      String serialNumber,
      String manufactureDate,
      String options)
      implements M12Message {

    @Override
    public String id() {
      return "Cj";
    }

    /** Parses the text of the message. */
    static ReceiverIdentification of(byte[] bytes, int from, int to) {
      String text = new String(bytes, from, to - from, StandardCharsets.US_ASCII);
      List<String> lines =
          new ArrayList<>(text.lines().map(ReceiverIdentification::cleaned).toList());
      return new ReceiverIdentification(
          lines.isEmpty() ? "" : lines.get(0),
          take(lines, "SFTW P/N #"),
          take(lines, "SOFTWARE VER #"),
          take(lines, "SOFTWARE REV #"),
          take(lines, "SOFTWARE DATE"),
          take(lines, "MODEL #"),
          take(lines, "HWDR P/N #"),
          take(lines, "SERIAL #"),
          take(lines, "MANUFACTUR DATE"),
          takeRest(lines, "OPTIONS LIST"));
    }

    private static String take(List<String> lines, String label) {
      for (String line : lines) {
        if (line.toUpperCase(Locale.ROOT).startsWith(label)) {
          return line.substring(label.length()).strip();
        }
      }
      return "";
    }

    private static String takeRest(List<String> lines, String label) {
      for (int i = 0; i < lines.size(); i++) {
        if (lines.get(i).toUpperCase(Locale.ROOT).startsWith(label)) {
          return String.join(" ", lines.subList(i, lines.size())).substring(label.length()).strip();
        }
      }
      return "";
    }

    /** Replaces each run of blanks and unprintable characters by one blank, and trims the line. */
    private static String cleaned(String line) {
      return line.replaceAll("[^\\x21-\\x7E]+", " ").strip();
    }
  }
}
