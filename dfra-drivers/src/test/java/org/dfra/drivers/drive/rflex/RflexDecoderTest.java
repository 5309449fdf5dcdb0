package org.dfra.drivers.drive.rflex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HexFormat;
import java.util.List;
import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.drivers.drive.rflex.RflexMessage.Echo;
import org.dfra.drivers.drive.rflex.RflexMessage.Malformed;
import org.dfra.drivers.drive.rflex.RflexMessage.MotorReport;
import org.dfra.drivers.drive.rflex.RflexMessage.Other;
import org.dfra.drivers.drive.rflex.RflexMessage.SonarReport;
import org.dfra.drivers.drive.rflex.RflexMessage.SystemStatus;
import org.junit.jupiter.api.Test;

/** Frames put together by hand from the table of the protocol, checksums by hand too. */
class RflexDecoderTest {

  private static List<RflexMessage> parse(String hex) {
    return RflexParser.parse(HexFormat.of().parseHex(hex.replace(" ", "")));
  }

  @Test
  void readsWhereAnAxisIs() {
    // Rotation at -36277 counts (FFFF724B), -18138 counts/s (FFFFB926), at 10.000000 s.
    assertThat(
            parse(
                "1B02 02 00 21 19 00000000 00989680 01 FFFF724B FFFFB926 00008DB5 00007530"
                    + " 6E 1B03"))
        .containsExactly(new MotorReport(10_000_000, Axis.ROTATION, -36277, -18138, 36277, 30000));
  }

  @Test
  void readsBatteryAndBrake() {
    // 24.30 V are 2430 = 97E hundredths
    assertThat(parse("1B02 01 00 01 09 00000001 0000097E 01 7E 1B03"))
        .containsExactly(new SystemStatus(1, 24.30, true));
    assertThat(parse("1B02 01 00 01 09 FFFFFFFF 0000097E 00 7E 1B03"))
        .containsExactly(new SystemStatus(0xFFFF_FFFFL, 24.30, false));
  }

  @Test
  void readsTheEchoesOfTheSonars() {
    // 1476 = 5C4 counts are 1 m
    List<RflexMessage> reported =
        parse("1B02 04 04 02 0E 00000000 00000005 03 05C4 0A 0B88 42 1B03");
    assertThat(reported).hasSize(1);
    SonarReport report = (SonarReport) reported.get(0);
    assertThat(report.timestamp()).isEqualTo(5);
    assertThat(report.echoes()).extracting(Echo::sonar).containsExactly(3, 10);
    assertThat(report.echoes().get(0).range()).isEqualTo(1.0);
    assertThat(report.echoes().get(1).range()).isCloseTo(2.0, within(1e-9));
    assertThat(parse("1B02 04 04 02 08 00000000 00000005 0F 1B03"))
        .containsExactly(new SonarReport(5, List.of()));
  }

  @Test
  void namesValuesThatCannotBe() {
    assertThat(
            parse(
                "1B02 02 00 21 19 00000000 00000000 07 00000000 00000000 00000000 00000000"
                    + " 3D 1B03"))
        .containsExactly(new Malformed(2, 33, "axis 7, but there are 0 and 1"));
    assertThat(parse("1B02 01 00 01 09 00000000 00FFFFFF 00 F6 1B03"))
        .containsExactly(new Malformed(1, 1, "a voltage of 167772.15 V, more than 60.0 V"));
  }

  @Test
  void passesOverWhatItHasNoUseFor() {
    assertThat(parse("1B02 05 00 02 03 010203 04 1B03")).containsExactly(new Other(5, 2, 3));
  }
}
