package org.dfra.drivers.gps.ubx;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.HexFormat;
import java.util.List;
import org.dfra.drivers.gps.ubx.UbxMessage.Ack;
import org.dfra.drivers.gps.ubx.UbxMessage.Malformed;
import org.dfra.drivers.gps.ubx.UbxMessage.NavPvt;
import org.dfra.drivers.gps.ubx.UbxMessage.NavSat;
import org.dfra.drivers.gps.ubx.UbxMessage.Satellite;
import org.dfra.drivers.gps.ubx.UbxMessage.Version;
import org.dfra.drivers.gps.ubx.UbxParser.UbxFramer;
import org.junit.jupiter.api.Test;

class UbxDecoderTest {

  private final int[] pvt = new int[92];

  UbxDecoderTest() {
    put(4, 2026, 2);
    put(6, 11, 1);
    put(7, 21, 1);
    put(8, 13, 1);
    put(9, 1, 1);
    put(10, 30, 1);
    put(11, 7, 1);
    put(16, -200_000_000, 4);
    put(20, 3, 1);
    put(21, 1, 1);
    put(23, 17, 1);
    put(24, -824_572_000, 4);
    put(28, 279_506_000, 4);
    put(32, 14_500, 4);
    put(36, 44_250, 4);
    put(40, 1250, 4);
    put(44, 2500, 4);
    put(48, -300, 4);
    put(52, 400, 4);
    put(56, 10, 4);
    put(60, 500, 4);
    put(64, 12_687_000, 4);
    put(76, 156, 2);
  }

  @Test
  void readsPositionVelocityAndTime() {
    assertThat(decode(UbxFramer.NAV_PVT, pvt))
        .isEqualTo(
            new NavPvt(
                Instant.parse("2026-11-21T13:01:29.8Z"), // a negative fraction
                true,
                3,
                true,
                17,
                27.9506,
                -82.4572,
                14.5,
                44.25,
                1.25,
                2.5,
                -0.3,
                0.4,
                0.01,
                0.5,
                126.87,
                1.56));
  }

  @Test
  void aPositionThatTheReceiverCallsInvalidIsNoFix() {
    put(78, 1, 1); // as with a fix of time only
    assertThat(((NavPvt) decode(UbxFramer.NAV_PVT, pvt)).fixOk()).isFalse();
  }

  @Test
  void knowsNoTimeThatIsNotValid() {
    put(11, 1, 1);
    put(6, 0, 1);
    NavPvt reported = (NavPvt) decode(UbxFramer.NAV_PVT, pvt);
    assertThat(reported.utc()).isNull();
    assertThat(reported.resolved()).isFalse();
  }

  @Test
  void aValueThatCannotBeMakesAMalformedMessage() {
    put(28, 900_000_001, 4);
    assertThat(decode(UbxFramer.NAV_PVT, pvt)).isInstanceOf(Malformed.class);
    put(28, 0, 4);
    put(24, -1_800_000_001, 4);
    assertThat(decode(UbxFramer.NAV_PVT, pvt)).isInstanceOf(Malformed.class);
    put(24, 0, 4);
    put(6, 13, 1);
    assertThat(decode(UbxFramer.NAV_PVT, pvt))
        .isEqualTo(
            new Malformed("NAV-PVT", "date and time said to be valid are not in the calendar"));
    put(6, 12, 1);
    put(60, -1, 4);
    assertThat(decode(UbxFramer.NAV_PVT, pvt))
        .isEqualTo(new Malformed("NAV-PVT", "ground speed -1 mm/s is not ≥ 0"));
    assertThat(decode(UbxFramer.NAV_SAT, new int[] {0, 0, 0, 0, 1, 9, 0, 0}))
        .isEqualTo(new Malformed("NAV-SAT", "9 satellites do not fit 8 bytes"));
  }

  @Test
  void readsSatellites() {
    int[] payload = new int[32];
    payload[5] = 2;
    int[] first = {0, 14, 47, 41, 60, 0, 0, 0, 0x0F};
    int[] second = {6, 3, 0, 0x100 - 91, 0, 0, 0, 0, 0x07};
    System.arraycopy(first, 0, payload, 8, first.length);
    System.arraycopy(second, 0, payload, 20, second.length);
    assertThat(decode(UbxFramer.NAV_SAT, payload))
        .isEqualTo(
            new NavSat(
                List.of(
                    new Satellite(0, 14, 47, 41, 60, true),
                    new Satellite(6, 3, 0, -91, 0, false))));
  }

  @Test
  void readsVersionsAndAcknowledgements() {
    int[] payload = new int[100];
    put(payload, 0, "ROM CORE 3.01 (107888)");
    put(payload, 30, "00080000");
    put(payload, 40, "FWVER=SPG 3.01");
    put(payload, 70, "MOD=NEO-M8N-0");
    Version version = (Version) decode(UbxFramer.MON_VER, payload);
    assertThat(version.software()).isEqualTo("ROM CORE 3.01 (107888)");
    assertThat(version.hardware()).isEqualTo("00080000");
    assertThat(version.extension("MOD")).isEqualTo("NEO-M8N-0");
    assertThat(version.extension("PROTVER")).isNull();
    assertThat(decode(UbxFramer.ACK_NAK, new int[] {6, 1}))
        .isEqualTo(new Ack(false, UbxCommands.CFG_MSG));
    assertThat(decode(0x0D03, new int[20]).name()).isEqualTo("0D03");
  }

  @Test
  void writesTheFramesOfTheDescription() {
    // The poll of MON-VER, as it is in every integration manual.
    assertThat(HexFormat.of().formatHex(UbxCommands.version())).isEqualTo("b5620a0400000e34");
    assertThat(HexFormat.of().formatHex(UbxCommands.positions()))
        .isEqualTo("b5620601030001070113" + "51");
  }

  private UbxMessage decode(int type, int[] payload) {
    byte[] frame = UbxCommands.encode(type, payload);
    List<UbxMessage> found = UbxParser.parse(frame);
    assertThat(found).hasSize(1);
    return found.get(0);
  }

  private void put(int offset, int value, int bytes) {
    for (int i = 0; i < bytes; i++) {
      pvt[offset + i] = value >> 8 * i & 0xFF;
    }
  }

  private static void put(int[] payload, int offset, String text) {
    for (int i = 0; i < text.length(); i++) {
      payload[offset + i] = text.charAt(i);
    }
  }
}
