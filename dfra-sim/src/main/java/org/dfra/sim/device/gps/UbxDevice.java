package org.dfra.sim.device.gps;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;

/**
 * Emulates a u-blox receiver at the byte level of its serial interface. It sends nothing
 * unsolicited until it is configured.
 *
 * <p>Commands: {@code CFG-MSG} of {@code NAV-PVT} and {@code NAV-SAT} (one in so many solutions, 0
 * never), {@code CFG-RATE} (a period of at least 50 ms), each acknowledged; {@code MON-VER}. It
 * rejects every other setting. Its settings survive a change of client. Source: u-blox receiver
 * descriptions.
 */
public final class UbxDevice extends StreamingDevice {

  private static final int NAV_PVT = 0x0107;
  private static final int NAV_SAT = 0x0135;
  private static final int CFG_MSG = 0x0601;
  private static final int CFG_RATE = 0x0608;
  private static final int MON_VER = 0x0A04;
  private static final int CFG = 0x06;
  private static final int LONGEST_COMMAND = 64;
  private static final int SHORTEST_PERIOD = 50; // milliseconds

  private final byte[] window = new byte[LONGEST_COMMAND];
  private int filled;
  private int positionsEvery;
  private int satellitesEvery;
  private long solutions;

  /**
   * @param path trajectory of its antenna
   * @param baud bits per second of its serial line
   * @param timeToFirstFix time from power-on to the first fix
   */
  public UbxDevice(AntennaTrajectory path, int baud, Duration timeToFirstFix) {
    super(path, baud, timeToFirstFix, false);
  }

  @Override
  void execute(byte[] bytes, int offset, int length, Instant time) {
    for (int i = offset; i < offset + length; i++) {
      window[filled++] = bytes[i];
      while (filled > 0 && !mayGrow()) {
        int used = Math.max(1, commandLength(time));
        System.arraycopy(window, used, window, 0, filled - used);
        filled -= used;
      }
    }
  }

  private boolean mayGrow() {
    if (window[0] != (byte) 0xB5 || (filled > 1 && window[1] != 0x62)) {
      return false;
    }
    return filled < 6 || (length() <= LONGEST_COMMAND && filled < length());
  }

  private int length() {
    return 8 + (window[4] & 0xFF) + ((window[5] & 0xFF) << 8);
  }

  /** Executes the command at the beginning; returns its length, 0 when there is none. */
  private int commandLength(Instant time) {
    if (filled < 8 || window[0] != (byte) 0xB5 || window[1] != 0x62 || filled < length()) {
      return 0;
    }
    int length = length();
    int sum = checksum(window, 2, length - 2);
    if (window[length - 2] != (byte) sum || window[length - 1] != (byte) (sum >> 8)) {
      return 0;
    }
    command((window[2] & 0xFF) << 8 | (window[3] & 0xFF), length - 8, time);
    return length;
  }

  private void command(int type, int payload, Instant time) {
    boolean executed = true;
    if (type == MON_VER && payload == 0) {
      send(version(), time);
    } else if (type == CFG_MSG && payload == 3) {
      executed = setMessage((window[6] & 0xFF) << 8 | (window[7] & 0xFF), window[8] & 0xFF);
    } else if (type == CFG_RATE && payload == 6) {
      int millis = (window[6] & 0xFF) | (window[7] & 0xFF) << 8;
      executed = millis >= SHORTEST_PERIOD;
      if (executed) {
        setPeriod(Duration.ofMillis(millis), time);
      }
    } else {
      executed = false;
    }
    if (type >> 8 == CFG) {
      send(frame(executed ? 0x0501 : 0x0500, new byte[] {(byte) (type >> 8), (byte) type}), time);
    }
  }

  private boolean setMessage(int type, int every) {
    if (type == NAV_PVT) {
      positionsEvery = every;
    } else if (type == NAV_SAT) {
      satellitesEvery = every;
    } else {
      return false;
    }
    setStreaming(positionsEvery > 0 || satellitesEvery > 0);
    return true;
  }

  @Override
  void sendPosition(Instant time, boolean hasFix, AntennaState antenna) {
    if (positionsEvery > 0 && solutions % positionsEvery == 0) {
      send(position(time, hasFix, antenna), time);
    }
    if (satellitesEvery > 0 && solutions % satellitesEvery == 0) {
      send(
          satellites(
              hasFix
                  ? SatelliteConstellation.withFix(time)
                  : SatelliteConstellation.searching(time)),
          time);
    }
    solutions++;
  }

  private static byte[] position(Instant time, boolean hasFix, AntennaState antenna) {
    Instant rounded = time.plusNanos(500_000_000); // to the nearest second, as the receiver does
    LocalDateTime utc = LocalDateTime.ofInstant(rounded, ZoneOffset.UTC).withNano(0);
    int nano = (int) Duration.between(utc.toInstant(ZoneOffset.UTC), time).toNanos();
    ByteBuffer out = ByteBuffer.allocate(92).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(0).putShort((short) utc.getYear());
    out.put((byte) utc.getMonthValue()).put((byte) utc.getDayOfMonth()).put((byte) utc.getHour());
    out.put((byte) utc.getMinute()).put((byte) utc.getSecond());
    out.put((byte) (hasFix ? 7 : 3)); // valid; resolved with the first fix
    out.putInt(25).putInt(nano); // time accuracy, ns
    SatelliteConstellation sky =
        hasFix ? SatelliteConstellation.withFix(time) : SatelliteConstellation.searching(time);
    out.put((byte) (hasFix ? 3 : 0)).put((byte) (hasFix ? 1 : 0)).put((byte) 0);
    out.put((byte) (hasFix ? sky.tracked(12) : 0));
    out.putInt((int) Math.round(antenna.position().longitude() * 1e7));
    out.putInt((int) Math.round(antenna.position().latitude() * 1e7));
    out.putInt((int) Math.round(antenna.position().height() * 1e3));
    out.putInt((int) Math.round((antenna.position().height() - NmeaDevice.GEOID) * 1e3));
    out.putInt(1500).putInt(2500); // accuracies, mm
    double course = Math.toRadians(antenna.course());
    out.putInt((int) Math.round(antenna.speed() * Math.cos(course) * 1e3));
    out.putInt((int) Math.round(antenna.speed() * Math.sin(course) * 1e3)).putInt(0);
    out.putInt((int) Math.round(antenna.speed() * 1e3));
    out.putInt((int) Math.round(antenna.course() * 1e5));
    out.putInt(100).putInt(100_000).putShort((short) (hasFix ? 180 : 9999));
    return frame(NAV_PVT, out.array());
  }

  private static byte[] satellites(SatelliteConstellation sky) {
    int count = sky.channels().size();
    ByteBuffer out = ByteBuffer.allocate(8 + 12 * count).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(0).put((byte) 1).put((byte) count).putShort((short) 0);
    for (SatelliteConstellation.Channel channel : sky.channels()) {
      out.put((byte) 0).put((byte) channel.satellite()).put((byte) channel.carrierToNoise());
      out.put((byte) channel.elevation()).putShort((short) channel.azimuth()).putShort((short) 0);
      out.putInt(channel.isUsed() ? 0x1F : 0x01);
    }
    return frame(NAV_SAT, out.array());
  }

  private static byte[] version() {
    byte[] payload = new byte[40 + 60];
    put(payload, 0, "EXT CORE 3.01 (EMULATOR)");
    put(payload, 30, "00080000");
    put(payload, 40, "PROTVER=18.00");
    put(payload, 70, "MOD=NEO-M8N-0");
    return frame(MON_VER, payload);
  }

  private static void put(byte[] payload, int at, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    System.arraycopy(bytes, 0, payload, at, bytes.length);
  }

  private static byte[] frame(int type, byte[] payload) {
    ByteBuffer out = ByteBuffer.allocate(payload.length + 8).order(ByteOrder.LITTLE_ENDIAN);
    out.put((byte) 0xB5).put((byte) 0x62).put((byte) (type >> 8)).put((byte) type);
    out.putShort((short) payload.length).put(payload);
    return out.putShort((short) checksum(out.array(), 2, out.position())).array();
  }

  private static int checksum(byte[] bytes, int from, int to) {
    int a = 0;
    int b = 0;
    for (int i = from; i < to; i++) {
      a = (a + bytes[i]) & 0xFF;
      b = (b + a) & 0xFF;
    }
    return b << 8 | a;
  }
}
