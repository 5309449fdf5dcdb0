package org.dfra.drivers.gps.m12;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalDateTime;
import org.dfra.drivers.fixture.Frames;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.gps.m12.M12Message.M12UtcOffset;
import org.dfra.drivers.gps.m12.M12Message.MalformedMessage;
import org.dfra.drivers.gps.m12.M12Message.OtherMessage;
import org.dfra.drivers.gps.m12.M12Message.PositionControl;
import org.dfra.drivers.gps.m12.M12Message.PositionHoldMode;
import org.dfra.drivers.gps.m12.M12Message.ReceiverClock;
import org.dfra.drivers.gps.m12.M12Message.ReceiverIdentification;
import org.dfra.drivers.gps.m12.M12Message.TimeRaim;
import org.dfra.drivers.gps.m12.M12Message.TimeScale;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Position;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Time;
import org.dfra.drivers.gps.m12.M12PositionMessage.ShortPosition;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class M12DecoderTest {

  private static final LocalDateTime TIME = LocalDateTime.of(2026, 1, 21, 7, 33, 29, 500_000_000);

  @ParameterizedTest
  @CsvSource({
    "15, 720000000, 4, latitude (mas) 720000000 is outside -324000000 to 324000000",
    "31, -324000001, 4, latitude (mas) -324000001 is outside -324000000 to 324000000",
    "19, 648000001, 4, longitude (mas) 648000001 is outside -648000000 to 648000000",
    "23, 1800001, 4, GPS height (cm) 1800001 is outside -100000 to 1800000",
    "39, -100001, 4, GPS height (cm) -100001 is outside -100000 to 1800000",
    "47, 65535, 2, speed (cm/s) 65535 is outside 0 to 51500",
    "49, 65535, 2, speed (cm/s) 65535 is outside 0 to 51500",
    "51, 3601, 2, heading (0.1°) 3601 is outside 0 to 3600",
    "53, 1000, 2, dilution (0.1) 1000 is outside 0 to 999",
    "56, 13, 1, satellites tracked 13 is outside 0 to 12",
    "58, 9, 1, mode of channel 0 9 is outside 0 to 8",
    "6, 0, 2, year 0 is outside 1980 to 9999",
    "8, 24, 1, hour 24 is outside 0 to 23",
    "9, 60, 1, minute 60 is outside 0 to 59",
    "10, 61, 1, second 61 is outside 0 to 60",
    "11, -1, 4, fraction (ns) 2147483647 is outside 0 to 999999999",
    "11, 1000000000, 4, fraction (ns) 1000000000 is outside 0 to 999999999",
  })
  void aValueThatCannotBeMakesAMalformedMessage(int offset, int value, int bytes, String reason) {
    byte[] frame = Frames.with(Frames.ha(TIME, 52.9, 6.8, Frames.FIX_3D), offset, value, bytes);
    assertThat(decode(frame)).isEqualTo(new MalformedMessage("Ha", reason));
  }

  @Test
  void aDateThatIsNotInTheCalendarIsMalformed() {
    byte[] frame = Frames.ha(LocalDateTime.of(2026, 2, 1, 0, 0), 52.9, 6.8, Frames.FIX_3D);
    assertThat(decode(Frames.with(frame, 5, 30, 1))).isInstanceOf(MalformedMessage.class);
    assertThat(decode(Frames.with(frame, 4, 0, 1))).isInstanceOf(MalformedMessage.class);
    byte[] old = Frames.ea(LocalDateTime.of(2026, 2, 1, 0, 0), 52.9, 6.8, 0x20);
    assertThat(decode(Frames.with(old, 4, 13, 1))).isInstanceOf(MalformedMessage.class);
  }

  @Test
  void theParserCountsMalformedFramesAndDeliversThem() {
    byte[] frame = Frames.with(Frames.ha(TIME, 52.9, 6.8, Frames.FIX_3D), 15, 200 * 3_600_000, 4);
    java.util.List<M12Message> messages = new java.util.ArrayList<>();
    M12Parser parser = new M12Parser(messages::add);
    parser.feed(frame, 0, frame.length);
    parser.feed(new byte[5], 0, 5);
    assertThat(messages).singleElement().isInstanceOf(MalformedMessage.class);
    assertThat(parser.counts()).isEqualTo(new StreamCounts(1, 5, 1));
  }

  @Test
  void decodesWhatTheReceiverAcknowledges() {
    assertThat(decode(M12Commands.positionControl(PositionControl.Mode.SURVEY)))
        .isEqualTo(new PositionControl(PositionControl.Mode.SURVEY));
    assertThat(decode(M12Commands.utcTime())).isEqualTo(new TimeScale(true));
    assertThat(decode(M12Commands.positionHold(PositionHoldMode.Mode.ON)))
        .isEqualTo(new PositionHoldMode(PositionHoldMode.Mode.ON));
    assertThat(decode(M12Commands.askPositionHold())).isInstanceOf(MalformedMessage.class);
    assertThat(decode(M12Commands.encode("Bo", 18))).isEqualTo(new M12UtcOffset(18));
    assertThat(new M12UtcOffset(0).isKnown()).isFalse();
    assertThat(decode(M12Commands.time(Instant.parse("2026-11-21T13:01:29.9Z"))))
        .isEqualTo(new ReceiverClock(new M12Time(LocalDate.of(2026, 11, 21), 13, 1, 29, 0), 0));
    assertThat(decode(M12Commands.encode("Gd", 4)))
        .isEqualTo(new MalformedMessage("Gd", "mode 4 is outside 0 to 3"));
    assertThat(decode(M12Commands.encode("Aw", 255))).isInstanceOf(MalformedMessage.class);
    assertThat(decode(M12Commands.askHoldPosition())).isInstanceOf(MalformedMessage.class);
  }

  @Test
  void readsTheShortPosition() {
    byte[] frame = Frames.hb(TIME, 52.9, 6.8, Frames.FIX_3D);
    frame = Frames.with(frame, 31, 130, 2);
    frame = Frames.with(frame, 33, 120, 2);
    frame = Frames.with(frame, 35, 3599, 2);
    frame = Frames.with(frame, 37, 18, 2);
    frame = Frames.with(frame, 39, 13 << 8 | 9, 2);
    ShortPosition message = (ShortPosition) decode(frame);
    assertThat(message.position()).isEqualTo(new M12Position(52.9, 6.8, 0, 0));
    assertThat(message.toFix())
        .isEqualTo(
            new GpsFix(
                GpsFix.Mode.FIX_3D,
                new GeoPosition(52.9, 6.8, 0),
                Instant.parse("2026-01-21T07:33:29.5Z"),
                1.2,
                359.9,
                1.8,
                13,
                9));
    assertThat(message.speed3d()).isEqualTo(1.3);
    assertThat(message.knowsUtc()).isFalse();
  }

  @Test
  void readsTimeRaimOfBothReceivers() {
    int[] twelve = new int[71];
    twelve[0] = 1; // pulse
    twelve[2] = 2; // solution unknown
    twelve[3] = 1; // detection only
    twelve[7] = 0x80; // satellite 8 taken out
    twelve[8] = 1; // accuracy 256 ns
    twelve[10] = 0xF9; // sawtooth −7 ns
    assertThat(decode(M12Commands.encode("Hn", twelve)))
        .isEqualTo(
            new TimeRaim(
                "Hn", true, TimeRaim.Solution.UNKNOWN, TimeRaim.Ability.DETECTION, 0x80, 256, -7));
    int[] eight = new int[62];
    eight[15] = 1;
    eight[20] = 54;
    eight[21] = 20;
    assertThat(decode(M12Commands.encode("En", eight)))
        .isEqualTo(
            new TimeRaim(
                "En",
                true,
                TimeRaim.Solution.OK,
                TimeRaim.Ability.DETECTION_AND_ISOLATION,
                0,
                54,
                20));
  }

  @Test
  void allowsTheCornersOfTheEarth() {
    for (double latitude : new double[] {-90, 0, 90}) {
      for (double longitude : new double[] {-180, 0, 180}) {
        Position12Channels message =
            (Position12Channels) decode(Frames.ha(TIME, latitude, longitude, Frames.FIX_3D));
        assertThat(message.position()).isEqualTo(new M12Position(latitude, longitude, 0, 0));
      }
    }
  }

  @Test
  void aLeapSecondStandsAtTheEndOfItsMinute() {
    byte[] frame =
        Frames.ha(LocalDateTime.of(2016, 12, 31, 23, 59, 0, 250_000_000), 1, 2, Frames.FIX_3D);
    M12PositionMessage message = (M12PositionMessage) decode(Frames.with(frame, 10, 60, 1));
    assertThat(message.time().second()).isEqualTo(60);
    assertThat(message.utc()).isEqualTo(Instant.parse("2016-12-31T23:59:59.999999999Z"));
  }

  @ParameterizedTest
  @CsvSource({ // UTC byte, UTC reported, known
    "0xD2, 2026-01-21T07:33:29.500Z, true", // UTC, offset known
    "0x52, 2026-01-21T07:33:11.500Z, true", // GPS time, offset known: converted
    "0x80, 2026-01-21T07:33:29.500Z, false", // UTC with an offset not known yet
    "0x12, 2026-01-21T07:33:29.500Z, false", // GPS time, offset not known yet
    "0x7F, 2026-01-21T07:33:30.500Z, true", // GPS time, offset −1: six bits with a sign
  })
  void convertsGpsTimeWhereTheOffsetIsKnown(int bits, Instant utc, boolean known) {
    byte[] frame = Frames.with(Frames.ha(TIME, 1, 2, Frames.FIX_3D), 141, bits, 1);
    M12PositionMessage message = (M12PositionMessage) decode(frame);
    assertThat(message.utc()).isEqualTo(utc);
    assertThat(message.knowsUtc()).isEqualTo(known);
  }

  @ParameterizedTest
  @CsvSource({
    "0xE000, FIX_3D",
    "0xC001, FIX_2D",
    "0xA000, NONE",
    "0x8401, POSITION_HOLD",
    "0x6088, NONE",
    "0x4000, NONE",
    "0x2000, NONE",
    "0x0000, NONE"
  })
  void twelveChannelStatusShowsWhatWasSolvedFor(int status, GpsFix.Mode mode) {
    GpsFix fix = ((M12PositionMessage) decode(Frames.ha(TIME, 1, 2, status))).toFix();
    assertThat(fix.mode()).isEqualTo(mode);
    assertThat(fix.position() == null).isEqualTo(mode == GpsFix.Mode.NONE);
  }

  @ParameterizedTest
  @CsvSource({
    "0x20, FIX_3D",
    "0x21, FIX_3D",
    "0x10, FIX_2D",
    "0x08, NONE",
    "0x80, NONE",
    "0xA0, NONE",
    "0x40, NONE",
    "0x0A, NONE",
    "0x00, NONE"
  })
  void eightChannelStatusShowsWhatWasSolvedFor(int status, GpsFix.Mode mode) {
    M12PositionMessage message = (M12PositionMessage) decode(Frames.ea(TIME, 1, 2, status));
    assertThat(message.toFix().mode()).isEqualTo(mode);
    assertThat(message.stateInWords()).contains("0 of 0 tracked");
  }

  @Test
  void statusBitsHaveNames() {
    ReceiverStatus status = new ReceiverStatus(0x6088 | 2 << 1);
    assertThat(status.state()).isEqualTo(ReceiverStatus.State.ACQUIRING);
    assertThat(status.antenna()).isEqualTo(ReceiverStatus.Antenna.UNDER_CURRENT);
    assertThat(status.coldStart()).isTrue();
    assertThat(status.tooFewSatellites()).isTrue();
    assertThat(status.narrowBand() || status.fastAcquisition() || status.filterReset()).isFalse();
    assertThat(status.differential() || status.positionLock() || status.autosurvey()).isFalse();
  }

  @Test
  void deliversWhatHasNoDecoderAsItCame() {
    assertThat(decode(M12Commands.encode("Bj", 18)))
        .isEqualTo(new OtherMessage("Bj", new byte[] {18}))
        .hasToString("OtherMessage[@@Bj 12]");
    OtherMessage message = new OtherMessage("Bj", new byte[] {18});
    message.payload()[0] = 0;
    assertThat(message.payload()).containsExactly(18);
  }

  @Test
  void findsTheIdentificationByItsLabels() {
    String text =
        String.join(
            "\r\n",
            "COPYRIGHT 1991-1998  SOMEBODY INC.  ",
            "MODEL #    P283T12T11  ", // another order than usual
            "SFTW P/N # 61-G10268A      ",
            "SOFTWARE VER # 2           ",
            "SOFTWARE REV # 0           ",
            "SOFTWARE DATE  AUG 14 2002 ",
            "SERIAL #   P04DC2     ",
            "MANUFACTUR DATE 2H17  ",
            "OPTIONS LIST    IB\0\0",
            "  MORE");
    int[] payload = new int[294 - 7];
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    for (int i = 0; i < payload.length; i++) {
      payload[i] = i < bytes.length ? bytes[i] : ' ';
    }
    assertThat(decode(M12Commands.encode("Cj", payload)))
        .isEqualTo(
            new ReceiverIdentification(
                "COPYRIGHT 1991-1998 SOMEBODY INC.",
                "61-G10268A",
                "2",
                "0",
                "AUG 14 2002",
                "P283T12T11",
                "", // not reported
                "P04DC2",
                "2H17",
                "IB MORE"));
  }

  private static M12Message decode(byte[] frame) {
    return M12Decoder.decode(frame, 0, frame.length);
  }
}
