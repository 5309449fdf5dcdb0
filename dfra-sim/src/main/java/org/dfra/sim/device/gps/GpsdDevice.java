package org.dfra.sim.device.gps;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;

/**
 * Emulates gpsd with one receiver that reports once a second. It first sends its version; {@code
 * ?WATCH} with {@code "enable":true} starts reports, {@code ?VERSION} and {@code ?DEVICES} are
 * queries. Everything else is an error. Source: gpsd's protocol documentation.
 */
public final class GpsdDevice extends StreamingDevice {

  private static final int LONGEST_COMMAND = 512;
  private static final String PATH = "/dev/emulator";
  private static final String VERSION =
      "{\"class\":\"VERSION\",\"release\":\"3.22\",\"rev\":\"emulator\",\"proto_major\":3,"
          + "\"proto_minor\":14}";
  private static final String DEVICES =
      "{\"class\":\"DEVICES\",\"devices\":[{\"class\":\"DEVICE\",\"path\":\""
          + PATH
          + "\",\"driver\":\"NMEA0183\",\"subtype\":\"emulator\",\"activated\":"
          + "\"2026-01-01T00:00:00.000Z\"}]}";

  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss.SSS'Z'").withZone(ZoneOffset.UTC);

  private final StringBuilder command = new StringBuilder();
  private boolean sendsGreeting = true;

  /**
   * @param path trajectory of its receiver's antenna
   * @param baud bits per second at which it sends lines
   * @param timeToFirstFix time from power-on to the first fix
   */
  public GpsdDevice(AntennaTrajectory path, int baud, Duration timeToFirstFix) {
    super(path, baud, timeToFirstFix, false);
  }

  @Override
  public void connected() {
    command.setLength(0);
    sendsGreeting = true;
    setStreaming(false);
  }

  @Override
  void execute(byte[] bytes, int offset, int length, Instant time) {
    for (int i = offset; i < offset + length; i++) {
      char each = (char) (bytes[i] & 0xFF);
      if (each == ';') {
        command(command.toString().strip(), time);
        command.setLength(0);
      } else if (command.length() < LONGEST_COMMAND) {
        command.append(each);
      }
    }
  }

  private void command(String text, Instant time) {
    if (sendsGreeting) {
      sendsGreeting = false;
      line(VERSION, time);
    }
    if (text.startsWith("?WATCH=")) {
      boolean on = text.contains("\"enable\":true");
      setStreaming(on);
      line(DEVICES, time);
      line("{\"class\":\"WATCH\",\"enable\":" + on + ",\"json\":true}", time);
    } else if (text.equals("?VERSION")) {
      line(VERSION, time);
    } else if (text.equals("?DEVICES")) {
      line(DEVICES, time);
    } else {
      line("{\"class\":\"ERROR\",\"message\":\"Unrecognized request\"}", time);
    }
  }

  @Override
  void sendPosition(Instant time, boolean hasFix, AntennaState antenna) {
    SatelliteConstellation sky =
        hasFix ? SatelliteConstellation.withFix(time) : SatelliteConstellation.searching(time);
    String satellites =
        sky.channels().stream()
            .map(
                channel ->
                    String.format(
                        Locale.ROOT,
                        "{\"PRN\":%d,\"el\":%.1f,\"az\":%.1f,\"ss\":%.1f,\"used\":%b,"
                            + "\"gnssid\":0,\"svid\":%d}",
                        channel.satellite(),
                        (double) channel.elevation(),
                        (double) channel.azimuth(),
                        (double) channel.carrierToNoise(),
                        hasFix && channel.isUsed(),
                        channel.satellite()))
            .collect(Collectors.joining(","));
    line(
        "{\"class\":\"SKY\",\"device\":\""
            + PATH
            + "\",\"hdop\":0.90,\"pdop\":1.80,\"satellites\":["
            + satellites
            + "]}",
        time);
    String sent = TIME.format(time);
    line(
        hasFix
            ? String.format(
                Locale.ROOT,
                "{\"class\":\"TPV\",\"device\":\"%s\",\"status\":1,\"mode\":3,\"time\":\"%s\","
                    + "\"lat\":%.9f,\"lon\":%.9f,\"altHAE\":%.4f,\"altMSL\":%.4f,\"track\":%.4f,"
                    + "\"speed\":%.3f,\"eph\":1.500,\"epv\":2.500}",
                PATH,
                sent,
                antenna.position().latitude(),
                antenna.position().longitude(),
                antenna.position().height(),
                antenna.position().height() - NmeaDevice.GEOID,
                antenna.course(),
                antenna.speed())
            : "{\"class\":\"TPV\",\"device\":\""
                + PATH
                + "\",\"mode\":1,\"time\":\""
                + sent
                + "\"}",
        time);
  }

  private void line(String text, Instant time) {
    send((text + "\r\n").getBytes(StandardCharsets.UTF_8), time);
  }
}
