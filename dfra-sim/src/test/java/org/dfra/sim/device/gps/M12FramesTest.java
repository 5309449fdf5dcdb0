package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.HexFormat;
import java.util.List;
import org.dfra.drivers.gps.m12.M12Message;
import org.dfra.drivers.gps.m12.M12Message.ReceiverIdentification;
import org.dfra.drivers.gps.m12.M12Parser;
import org.dfra.drivers.gps.m12.M12PositionMessage.SatelliteChannel;
import org.dfra.drivers.gps.m12.Position12Channels;
import org.dfra.drivers.gps.m12.Position8Channels;
import org.dfra.drivers.gps.m12.ReceiverStatus;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;
import org.dfra.sim.device.gps.M12Frames.Moment.Solution;
import org.dfra.sim.device.gps.M12Frames.Moment.TimeScale;
import org.junit.jupiter.api.Test;

/** Bytes against the user's guide, and against the driver's decoder, which shares no code. */
class M12FramesTest {

  private static final Instant TIME = Instant.parse("2026-01-21T07:33:29.000336301Z");
  private static final GeoPosition PLACE = new GeoPosition(-33.123456789, 151.987654321, 55.91);
  private static final AntennaState ANTENNA = new AntennaState(PLACE, 1.25, 271.5);

  /** Half a milli-arc-second, what rounding to one may cost. */
  private static final double HALF_MAS = 0.5 / 3_600_000 + 1e-12;

  @Test
  void laysOutTheTwelveChannelMessageAsTheGuideDoes() {
    GeoPosition place = new GeoPosition(190_477_129 / 3.6e6, 24_720_144 / 3.6e6, 55.91);
    byte[] frame =
        M12Frames.position12(
            new M12Frames.Moment(
                TIME, 18, TimeScale.UTC, Solution.FIX_3D, new AntennaState(place, 0, 0)));
    assertThat(frame).hasSize(154);
    // head, date, time and four coordinates: the bytes a real receiver sent at this place and time
    assertThat(HexFormat.of().formatHex(frame, 0, 31))
        .isEqualTo("40404861" + "011507ea07211d000521ad" + "0b5a734901793310000015d700000000");
    assertThat(frame[129] & 0xFF).isEqualTo(0xE4); // 3-D, narrow band
    assertThat(frame[141] & 0xFF).isEqualTo(0x80 | 0x40 | 18); // as the real one has it
    assertThat(HexFormat.of().formatHex(frame, 152, 154)).isEqualTo("0d0a");
    byte sum = 0;
    for (int i = 2; i < 151; i++) {
      sum ^= frame[i];
    }
    assertThat(frame[151]).isEqualTo(sum);
  }

  @Test
  void theDriverReadsTheTwelveChannelMessage() {
    Position12Channels message =
        (Position12Channels)
            decoded(
                M12Frames.position12(
                    new M12Frames.Moment(TIME, 18, TimeScale.UTC, Solution.FIX_3D, ANTENNA)));
    assertThat(message.utc()).isEqualTo(TIME);
    assertThat(message.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    assertThat(message.position().latitude()).isCloseTo(PLACE.latitude(), within(HALF_MAS));
    assertThat(message.position().longitude()).isCloseTo(PLACE.longitude(), within(HALF_MAS));
    assertThat(message.position().height()).isEqualTo(55.91);
    assertThat(message.unfiltered()).isEqualTo(message.position());
    assertThat(message.groundSpeed()).isEqualTo(1.25);
    assertThat(message.heading()).isEqualTo(271.5);
    assertThat(message.dilution()).isEqualTo(1.8);
    assertThat(message.tracked()).isEqualTo(9);
    assertThat(message.channels().stream().filter(SatelliteChannel::isAvailable)).hasSize(9);
    assertThat(message.visible()).isGreaterThanOrEqualTo(message.tracked());
    assertThat(message.status().antenna()).isEqualTo(ReceiverStatus.Antenna.OK);
    assertThat(message.temperature()).isEqualTo(28);
    assertThat(message.idTag()).isEqualTo("EMU001");
    assertThat(message.utcState().offset()).isEqualTo(18);
  }

  @Test
  void theDriverReadsTheEightChannelMessage() {
    byte[] frame =
        M12Frames.position8(
            new M12Frames.Moment(TIME, 18, TimeScale.UTC, Solution.FIX_3D, ANTENNA));
    assertThat(frame).hasSize(76);
    Position8Channels message = (Position8Channels) decoded(frame);
    assertThat(message.utc()).isEqualTo(TIME);
    assertThat(message.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    assertThat(message.position().latitude()).isCloseTo(PLACE.latitude(), within(HALF_MAS));
    assertThat(message.groundSpeed()).isEqualTo(1.25);
    assertThat(message.tracked()).isEqualTo(8);
    assertThat(message.antenna()).isEqualTo(ReceiverStatus.Antenna.OK);
  }

  @Test
  void aReceiverThatSearchesHasNoFix() {
    Position12Channels message =
        (Position12Channels)
            decoded(
                M12Frames.position12(
                    new M12Frames.Moment(TIME, 18, TimeScale.UTC, Solution.ACQUIRING, ANTENNA)));
    assertThat(message.mode()).isEqualTo(GpsFix.Mode.NONE);
    assertThat(message.status().state()).isEqualTo(ReceiverStatus.State.ACQUIRING);
    assertThat(message.status().tooFewSatellites()).isTrue();
    assertThat(message.tracked()).isEqualTo(2);
    Position8Channels old =
        (Position8Channels)
            decoded(
                M12Frames.position8(
                    new M12Frames.Moment(TIME, 18, TimeScale.UTC, Solution.ACQUIRING, ANTENNA)));
    assertThat(old.mode()).isEqualTo(GpsFix.Mode.NONE);
  }

  @Test
  void gpsTimeIsAheadOfUtcAndTheDriverConvertsIt() {
    Position12Channels message =
        (Position12Channels)
            decoded(
                M12Frames.position12(
                    new M12Frames.Moment(TIME, 18, TimeScale.GPS, Solution.FIX_3D, ANTENNA)));
    assertThat(message.time().second()).isEqualTo((29 + 18) % 60);
    assertThat(message.utc()).isEqualTo(TIME);
  }

  @Test
  void theDriverReadsTheIdentification() {
    byte[] frame = M12Frames.identification();
    assertThat(frame).hasSize(294);
    ReceiverIdentification receiver = (ReceiverIdentification) decoded(frame);
    assertThat(receiver.softwarePartNumber()).isEqualTo("61-G10268A");
    assertThat(receiver.softwareVersion()).isEqualTo("2");
    assertThat(receiver.softwareDate()).isEqualTo("AUG 14 2002");
    assertThat(receiver.model()).isEqualTo("P283T12T11");
    assertThat(receiver.serialNumber()).isEqualTo("EMU001");
    assertThat(receiver.options()).isEqualTo("NONE");
  }

  @Test
  void theCornersOfTheEarthAreWrittenAndRead() {
    for (double latitude : new double[] {-90, 0, 90}) {
      for (double longitude : new double[] {-180, 0, 180}) {
        AntennaState corner = new AntennaState(new GeoPosition(latitude, longitude, -400), 0, 0);
        Position12Channels message =
            (Position12Channels)
                decoded(
                    M12Frames.position12(
                        new M12Frames.Moment(TIME, 18, TimeScale.UTC, Solution.FIX_3D, corner)));
        assertThat(message.position().toGeoPosition()).isEqualTo(corner.position());
      }
    }
  }

  private static M12Message decoded(byte[] frame) {
    List<M12Message> messages = M12Parser.parse(frame);
    assertThat(messages).hasSize(1);
    return messages.get(0);
  }
}
