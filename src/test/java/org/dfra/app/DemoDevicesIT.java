package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/** {@code ./dfra demo devices}. */
class DemoDevicesIT extends DemoPlay {

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes a minute")
  void theDevicesTellTheirStoryAndLeaveNothingBehindButAReport() throws Exception {
    play(
        "devices",
        "A world begins, and a robot comes up in it",
        "7 lines lead to devices of atrv1",
        "The robot is up after",
        "A client asks for what it needs",
        "a drive that goes at 0.5 m/s or faster atrv1/drive",
        "a camera for heat atrv1/thermal",
        "It drives a square, and loses its drive on the way",
        "was killed: the one that drives",
        "it took a new one, looked where it was, and finished the square",
        "It turns its head, and its cameras with it",
        "6 images are in the report",
        "What truly happened",
        "The wheels stood",
        "The report",
        "All is shut down: none of the",
        "Measured",
        "cold start to every device working and shown",
        "drive's last command to the robot standing");

    String html = Files.readString(report().resolve("report.html"));
    assertThat(html).contains("Where it went", "drive killed", "<img src=\"data:image/png;base64,");
    try (var files = Files.list(report())) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .contains("truth.csv", "atrv1-drive.csv", "atrv1-laser.csv", "atrv1-thermal.csv");
    }
    assertThat(Files.readAllLines(report().resolve("atrv1-odometry.csv")))
        .as("readings of the odometry")
        .hasSizeGreaterThan(100);
  }
}
