package org.dfra.sim.device.gps;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Locale;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;

/**
 * A multi-constellation receiver that sends NMEA 0183 once a second: {@code GNRMC}, {@code GNGGA},
 * {@code GNGSA}, {@code GPGSV}. It takes no commands. Source: NMEA 0183, version 3.01.
 */
public final class NmeaDevice extends StreamingDevice {

  /** Height of mean sea level above the ellipsoid, metres: the same everywhere in this world. */
  static final double GEOID = 40;

  private static final int IN_A_SENTENCE = 4;

  /**
   * @param path trajectory of its antenna
   * @param baud bits per second of its serial line
   * @param timeToFirstFix time from power-on to the first fix
   */
  public NmeaDevice(AntennaTrajectory path, int baud, Duration timeToFirstFix) {
    super(path, baud, timeToFirstFix, true);
  }

  @Override
  void execute(byte[] bytes, int offset, int length, Instant time) {
    // it needs no configuration
  }

  @Override
  void sendPosition(Instant time, boolean hasFix, AntennaState antenna) {
    LocalDateTime utc = LocalDateTime.ofInstant(time, ZoneOffset.UTC);
    SatelliteConstellation sky =
        hasFix ? SatelliteConstellation.withFix(time) : SatelliteConstellation.searching(time);
    String clock =
        String.format(
            Locale.ROOT,
            "%02d%02d%02d.%03d",
            utc.getHour(),
            utc.getMinute(),
            utc.getSecond(),
            utc.getNano() / 1_000_000);
    String date =
        String.format(
            Locale.ROOT,
            "%02d%02d%02d",
            utc.getDayOfMonth(),
            utc.getMonthValue(),
            utc.getYear() % 100);
    String place =
        hasFix
            ? angle(antenna.position().latitude(), 2, "N", "S")
                + ","
                + angle(antenna.position().longitude(), 3, "E", "W")
            : ",,,";
    String motion =
        hasFix
            ? String.format(
                Locale.ROOT, "%.3f,%.2f", antenna.speed() * 3600 / 1852, antenna.course())
            : ",";
    sentence(
        "GNRMC,%s,%s,%s,%s,%s,,,%s",
        time, clock, hasFix ? "A" : "V", place, motion, date, hasFix ? "A" : "N");
    String height =
        hasFix
            ? String.format(
                Locale.ROOT, "%.2f,M,%.1f,M", antenna.position().height() - GEOID, GEOID)
            : ",M,,M";
    sentence(
        "GNGGA,%s,%s,%d,%02d,%s,%s,,",
        time, clock, place, hasFix ? 1 : 0, sky.tracked(12), hasFix ? "0.9" : "99.9", height);
    StringBuilder used = new StringBuilder();
    List<SatelliteConstellation.Channel> channels = sky.channels();
    for (int i = 0; i < 12; i++) {
      boolean uses = hasFix && i < channels.size() && channels.get(i).isUsed();
      used.append(uses ? String.format("%02d", channels.get(i).satellite()) : "").append(',');
    }
    sentence(
        "GNGSA,A,%d,%s%s", time, hasFix ? 3 : 1, used, hasFix ? "1.8,0.9,1.5" : "99.9,99.9,99.9");
    sendSatellites(channels, time);
  }

  private void sendSatellites(List<SatelliteConstellation.Channel> channels, Instant time) {
    int sentences = (channels.size() + IN_A_SENTENCE - 1) / IN_A_SENTENCE;
    for (int i = 0; i < sentences; i++) {
      StringBuilder blocks = new StringBuilder();
      int end = Math.min(channels.size(), (i + 1) * IN_A_SENTENCE);
      for (SatelliteConstellation.Channel channel : channels.subList(i * IN_A_SENTENCE, end)) {
        String strength = channel.isUsed() ? Integer.toString(channel.carrierToNoise()) : "";
        blocks.append(
            String.format(
                ",%02d,%02d,%03d,%s",
                channel.satellite(), channel.elevation(), channel.azimuth(), strength));
      }
      sentence("GPGSV,%d,%d,%02d%s", time, sentences, i + 1, channels.size(), blocks);
    }
  }

  /** {@code dddmm.mmmmmm,N}. */
  private static String angle(double degrees, int digits, String positive, String negative) {
    long micros = Math.round(Math.abs(degrees) * 60 * 1e6); // millionths of a minute
    return String.format(
        Locale.ROOT,
        "%0" + digits + "d%02d.%06d,%s",
        micros / 60_000_000,
        micros / 1_000_000 % 60,
        micros % 1_000_000,
        degrees < 0 ? negative : positive);
  }

  private void sentence(String form, Instant time, Object... values) {
    String body = String.format(Locale.ROOT, form, values);
    int sum = body.chars().reduce(0, (left, right) -> left ^ right);
    String line = String.format(Locale.ROOT, "$%s*%02X\r\n", body, sum);
    send(line.getBytes(StandardCharsets.US_ASCII), time);
  }
}
