package org.dfra.drivers.uav.mavlink;

import io.dronefleet.mavlink.MavlinkDialect;
import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import io.dronefleet.mavlink.ardupilotmega.ArdupilotmegaDialect;
import org.jspecify.annotations.Nullable;

/**
 * The messages that are known: those of the common dialect and of ArduPilot's. Safe for use by
 * several threads.
 */
final class MavlinkCatalogue {

  /** Answer of {@link #crcExtra} for a message that is not known. */
  static final int UNKNOWN = -1;

  private static final MavlinkDialect DIALECT = new ArdupilotmegaDialect();

  /** The answers given so far, plus 2; 0 is not asked yet. Every thread would find the same. */
  private static final short[] EXTRAS = new short[1 << 16];

  private MavlinkCatalogue() {}

  /**
   * The byte that stands for the message's definition in its checksum, 0 to 255; {@link #UNKNOWN}
   * where the message is not known, so that no frame of it can be told from noise.
   */
  static int crcExtra(int message) {
    if (message < 0 || message >= EXTRAS.length) {
      return UNKNOWN;
    }
    if (EXTRAS[message] == 0) {
      @Nullable Class<?> type = type(message);
      int extra =
          type == null ? UNKNOWN : type.getAnnotation(MavlinkMessageInfo.class).crc() & 0xFF;
      EXTRAS[message] = (short) (extra + 2);
    }
    return EXTRAS[message] - 2;
  }

  /** The message's name in the form of its class, e.g. {@code Attitude}; its number if unknown. */
  static String name(int message) {
    @Nullable Class<?> type = type(message);
    return type == null ? Integer.toString(message) : type.getSimpleName();
  }

  private static @Nullable Class<?> type(int message) {
    return DIALECT.supports(message) ? DIALECT.resolve(message) : null;
  }
}
