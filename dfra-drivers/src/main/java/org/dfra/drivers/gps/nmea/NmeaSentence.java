package org.dfra.drivers.gps.nmea;

import java.time.LocalDate;
import java.time.LocalTime;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A sentence from a receiver, decoded from one intact line. An empty field is NaN, null or −1, as
 * documented for each field.
 */
public sealed interface NmeaSentence {

  /**
   * The talker ID: {@code GP} GPS, {@code GL} GLONASS, {@code GA} Galileo, {@code GB} or {@code BD}
   * BeiDou, {@code GQ} or {@code QZ} QZSS, {@code GI} or {@code IR} NavIC, {@code GN} several at
   * once.
   */
  String talker();

  /**
   * {@code RMC}: recommended minimum.
   *
   * @param talker talker ID
   * @param time time of day, UTC; null while the receiver has none
   * @param valid whether the receiver marks it valid
   * @param latitude degrees, north is +; NaN if empty
   * @param longitude degrees, east is +; NaN if empty
   * @param speed over ground, metres per second; NaN if empty
   * @param course direction of travel, degrees, 0 is true north, clockwise is +; NaN if empty
   * @param date the date, UTC; null if empty
   * @param mode {@code A} autonomous, {@code D} differential, {@code E} estimated, {@code M}
   *     manual, {@code N} none, {@code R}/{@code F} real time kinematic, {@code S} simulator; a
   *     blank where the receiver's standard has no such field
   */
  record Rmc(
      String talker,
      @Nullable LocalTime time,
      boolean valid,
      double latitude,
      double longitude,
      double speed,
      double course,
      @Nullable LocalDate date,
      char mode)
      implements NmeaSentence {}

  /**
   * {@code GGA}: fix data.
   *
   * @param talker talker ID
   * @param time time of day, UTC; null while the receiver has none
   * @param latitude degrees, north is +; NaN if empty
   * @param longitude degrees, east is +; NaN if empty
   * @param quality 0 none, 1 GPS, 2 differential, 3 PPS, 4 and 5 real time kinematic, 6 estimated,
   *     7 manual, 8 simulator
   * @param used satellites in use; −1 if empty
   * @param dilution horizontal dilution of precision; NaN if empty
   * @param altitude above mean sea level, metres; NaN if empty
   * @param separation height of mean sea level above the WGS84 ellipsoid, metres; NaN if empty
   */
  record Gga(
      String talker,
      @Nullable LocalTime time,
      double latitude,
      double longitude,
      int quality,
      int used,
      double dilution,
      double altitude,
      double separation)
      implements NmeaSentence {}

  /**
   * {@code GNS}: fix data of several systems.
   *
   * @param talker talker ID
   * @param time time of day, UTC; null while the receiver has none
   * @param latitude degrees, north is +; NaN if empty
   * @param longitude degrees, east is +; NaN if empty
   * @param modes a letter for each system, in the order GPS, GLONASS, Galileo, BeiDou, QZSS, NavIC:
   *     as in {@link Rmc#mode}, and {@code P} precise; empty in the further sentences of an epoch,
   *     one for each system, which have no position
   * @param used satellites in use; −1 if empty
   * @param dilution horizontal dilution of precision; NaN if empty
   * @param altitude above mean sea level, metres; NaN if empty
   * @param separation height of mean sea level above the WGS84 ellipsoid, metres; NaN if empty
   */
  record Gns(
      String talker,
      @Nullable LocalTime time,
      double latitude,
      double longitude,
      String modes,
      int used,
      double dilution,
      double altitude,
      double separation)
      implements NmeaSentence {

    /**
     * From the best mode to the worst; each has its quality at the same index in {@link
     * #QUALITIES}.
     */
    private static final String BEST_FIRST = "RFPDASME";

    private static final int[] QUALITIES = {4, 5, 3, 2, 1, 8, 7, 6};

    /** The best mode of all systems as {@link Gga#quality} numbers it. */
    int quality() {
      for (int i = 0; i < QUALITIES.length; i++) {
        if (modes.indexOf(BEST_FIRST.charAt(i)) >= 0) {
          return QUALITIES[i];
        }
      }
      return 0;
    }

    /** Converts it to {@code GGA}, the sentence for one system. */
    Gga toGga() {
      return new Gga(
          talker, time, latitude, longitude, quality(), used, dilution, altitude, separation);
    }
  }

  /**
   * {@code VTG}: course and speed. It has no time: it belongs to the epoch that was reported before
   * it.
   *
   * @param talker talker ID
   * @param course direction of travel, degrees, 0 is true north, clockwise is +; NaN if empty
   * @param speed over ground, metres per second; NaN if empty
   * @param mode as in {@link Rmc#mode}
   */
  record Vtg(String talker, double course, double speed, char mode) implements NmeaSentence {}

  /**
   * {@code ZDA}: date and time.
   *
   * @param talker talker ID
   * @param time time of day, UTC; null if empty
   * @param date the date, UTC; null if empty
   * @param localZone minutes to be added to local time for UTC, negative east of Greenwich; null if
   *     empty. Reported, not applied: time and date are UTC
   */
  record Zda(
      String talker,
      @Nullable LocalTime time,
      @Nullable LocalDate date,
      @Nullable Integer localZone)
      implements NmeaSentence {}

  /**
   * {@code GSA}: satellites in use and dilution of precision.
   *
   * @param talker talker ID
   * @param dimensions 1 no fix, 2 a 2-D fix, 3 a 3-D fix; −1 if empty
   * @param satellites numbers of those in use, at most twelve
   * @param pdop dilution of precision of the position; NaN if empty
   * @param hdop the same, horizontal
   * @param vdop the same, vertical
   * @param system 1 GPS, 2 GLONASS, 3 Galileo, 4 BeiDou, 5 QZSS, 6 NavIC; −1 where not reported
   */
  record Gsa(
      String talker,
      int dimensions,
      List<Integer> satellites,
      double pdop,
      double hdop,
      double vdop,
      int system)
      implements NmeaSentence {}

  /**
   * {@code GSV}: satellites in view, at most four in a sentence.
   *
   * @param talker talker ID
   * @param total number of sentences in the set
   * @param number which one this is, from 1
   * @param inView how many satellites are in view
   * @param satellites the satellites of this sentence
   * @param signal which of the satellites' signals; −1 where not reported
   */
  record Gsv(
      String talker, int total, int number, int inView, List<Satellite> satellites, int signal)
      implements NmeaSentence {}

  /**
   * A satellite in view.
   *
   * @param number its number, in the receiver's numbering
   * @param elevation above the horizon, degrees; −1 if empty
   * @param azimuth from true north, clockwise, degrees; −1 if empty
   * @param signal carrier to noise density, dB-Hz; −1 if it is not tracked
   */
  record Satellite(int number, int elevation, int azimuth, int signal) {}

  /** An intact sentence of another type, or a proprietary one. */
  record Other(String talker, String type) implements NmeaSentence {}

  /**
   * An intact sentence with invalid content.
   *
   * @param reason which field, what it is and what it may be
   */
  record Malformed(String talker, String type, String reason) implements NmeaSentence {}
}
