package org.dfra.dist;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Map;
import java.util.UUID;
import org.dfra.core.host.FreePorts;
import org.dfra.dist.Installation.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code ./dfra dist}: a robot is brought up from what was unpacked, where nothing can compile. */
class DistIT {

  @TempDir Path folder;

  @Test
  void aRobotIsBroughtUpAndDownFromWhatWasUnpacked() throws Exception {
    Map<String, String> robot =
        Map.of(
            "DFRA_HOST",
            "127.0.0.1",
            "DFRA_TEAM",
            "dist-" + UUID.randomUUID(),
            "DFRA_WAIT",
            "20",
            "DFRA_ATRV1_REGISTRAR_PORT",
            Integer.toString(FreePorts.allocate()),
            "DFRA_ATRV1_CLASS_PORT",
            Integer.toString(FreePorts.allocate()),
            // Nobody answers there: the module is up all the same, and goes on trying.
            "DFRA_ATRV1_GPS_FRONT_LINK",
            "tcp://127.0.0.1:" + FreePorts.allocate());
    try (Installation installed = new Installation(folder)) {
      assertThat(installed.dfra(robot, "--version").out()).startsWith("dfra ");
      assertThat(installed.dfra(robot, "help").out())
          .contains("up ", "doctor ")
          .doesNotContain("by the script itself", "./dfra ");

      Outcome early = installed.dfra(robot, "status");
      assertThat(early.exit()).isEqualTo(4);
      assertThat(early.err()).contains("bring a robot up first: dfra up ROBOT.XML");

      Outcome up =
          installed.dfra(robot, "up", "--port=" + FreePorts.allocate(), "--registry-port=-1");
      assertThat(up.exit()).as(up.out() + up.err()).isZero();
      assertThat(up.out())
          .contains("Up: atrv1/registrar in group lookup.", "Up: atrv1/gps_front in group gps.")
          .contains("How they are: dfra status");
      assertThat(installed.living()).as("phoenix and two groups").hasSize(3);
      String pid = Files.readString(folder.resolve("state/phoenix.pid")).strip();
      assertThat(up.out()).contains("Started phoenix: process " + pid + ",");

      assertThat(installed.dfra(robot, "module", "list", "--team=").out())
          .containsPattern("atrv1/gps_front +GPSSensor");

      Outcome doctor = installed.dfra(robot, "doctor", "--team=");
      assertThat(doctor.exit()).as(doctor.out() + doctor.err()).isZero();
      assertThat(doctor.out()).contains(" at " + installed.java(), installed.home() + "/lib/boot/");

      Outcome down = installed.dfra(robot, "down");
      assertThat(down.exit()).as(down.out() + down.err()).isZero();
      await()
          .atMost(Duration.ofSeconds(20))
          .untilAsserted(() -> assertThat(installed.living()).isEmpty());
    }
  }

  @Test
  void theSameJarsGiveTheSameBytes() throws Exception {
    Path one = Installation.pack(folder.resolve("one"));
    Path other = Installation.pack(folder.resolve("other"));
    assertThat(Files.mismatch(one, other)).as("first byte that differs").isEqualTo(-1);
    String listed =
        Installation.run(Map.of("TZ", "UTC"), "tar", "--numeric-owner", "-tvzf", one.toString())
            .out();
    assertThat(listed.lines())
        .allSatisfy(line -> assertThat(line).contains(" 0/0 "))
        .anyMatch(line -> line.startsWith("-rwxr-xr-x") && line.endsWith("/bin/dfra"))
        .anyMatch(line -> line.endsWith("/lib/dfra-app.jar"))
        .anyMatch(line -> line.endsWith("/lib/boot/dfra-activation.jar"))
        .anyMatch(line -> line.endsWith("/lib/dl/dfra-river-dl.jar"))
        .anyMatch(line -> line.endsWith("/config/robots/atrv1.xml"))
        .anyMatch(line -> line.endsWith("/config/fuzzy/waypoint.fis"))
        .noneMatch(line -> line.contains("VectorGraphics2D")) // under the LGPL
        .anyMatch(line -> line.endsWith("/docs/troubleshooting.md"))
        .anyMatch(line -> line.endsWith("/systemd/dfra.service"))
        .anyMatch(line -> line.endsWith("/README.md"));
    try (var left = Files.list(one.getParent())) {
      assertThat(left).as("nothing else is left").containsExactly(one);
    }
  }

  @Test
  void systemdUnderstandsTheUnit() throws Exception {
    assumeTrue(
        Arrays.stream(System.getenv("PATH").split(":"))
            .anyMatch(each -> Files.isExecutable(Path.of(each, "systemd-analyze"))),
        "systemd-analyze is not installed here");
    Path command = Files.writeString(folder.resolve("dfra"), "#!/bin/sh\n");
    assertThat(command.toFile().setExecutable(true)).isTrue();
    Path root = Path.of(System.getProperty("dfra.root"));
    String unit = Files.readString(root.resolve("src/dist/systemd/dfra.service"));
    Path here =
        Files.writeString(
            folder.resolve("dfra.service"), unit.replace("/opt/dfra/bin/dfra", command.toString()));
    Outcome verified =
        Installation.start(Map.of(), "systemd-analyze", "verify", "--man=no", here.toString());
    assertThat(verified.out() + verified.err())
        .as("what it says of this unit")
        .doesNotContain("dfra.service");
    assertThat(verified.exit()).as(verified.err()).isZero();
  }
}
