package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.drivers.gps.m12.M12Commands;
import org.dfra.drivers.gps.m12.M12Parser;
import org.dfra.drivers.gps.m12.M12PositionMessage;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;
import org.junit.jupiter.api.Test;

/** Receivers whose antenna receives no satellites from second 5 to second 10 report that. */
class LostSkyTest {

  private static final Instant BEGIN = Instant.parse("2026-04-01T10:00:00Z");
  private static final AntennaState THERE = new AntennaState(new GeoPosition(48, 11, 520), 0, 0);

  private static final AntennaTrajectory PATH =
      new AntennaTrajectory() {
        @Override
        public AntennaState at(Instant time) {
          return THERE;
        }

        @Override
        public boolean hasSatellites(Instant time) {
          return time.isBefore(BEGIN.plusSeconds(5)) || !time.isBefore(BEGIN.plusSeconds(10));
        }
      };

  /** What it says in 14 s. */
  private static byte[] run(SerialDevice device) {
    ByteBuffer all = ByteBuffer.allocate(1 << 16);
    for (int tenth = 0; tenth < 140; tenth++) {
      device.transmit(all, BEGIN.plusMillis(100L * tenth));
    }
    byte[] bytes = new byte[all.position()];
    all.flip().get(bytes);
    return bytes;
  }

  @Test
  void anM12HasNoFixWithoutSky() {
    M12Device device = new M12Device(PATH, 115_200, Duration.ZERO);
    byte[] command = M12Commands.positionOf12Channels(1);
    device.receive(command, 0, command.length, BEGIN);
    List<GpsFix.Mode> modes = new ArrayList<>();
    byte[] bytes = run(device);
    new M12Parser(message -> modes.add(((M12PositionMessage) message).mode()))
        .feed(bytes, 0, bytes.length);
    assertThat(modes).hasSize(14);
    for (int second = 0; second < 14; second++) {
      boolean hasSky = second < 5 || second >= 10;
      assertThat(modes.get(second))
          .as("in second %d", second)
          .isEqualTo(hasSky ? GpsFix.Mode.FIX_3D : GpsFix.Mode.NONE);
    }
  }

  @Test
  void aStreamingReceiverHasNoneEither() {
    String text =
        new String(run(new NmeaDevice(PATH, 115_200, Duration.ZERO)), StandardCharsets.US_ASCII);
    List<Boolean> fixes =
        text.lines()
            .filter(line -> line.startsWith("$GNRMC"))
            .map(line -> line.split(",")[2].equals("A"))
            .toList();
    assertThat(fixes).hasSize(13); // the first in the first full second
    assertThat(fixes.subList(0, 4)).containsOnly(true);
    assertThat(fixes.subList(4, 9)).containsOnly(false);
    assertThat(fixes.subList(9, 13)).containsOnly(true);
  }
}
