package org.dfra.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/** {@code ./dfra demo devices}. */
class DemoDevicesIT extends DemoPlay {

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes a minute")
  void theDevicesDemoReportsItsStepsAndLeavesNothingBehindButAReport() throws Exception {
    play(
        "devices",
        "A world starts, and a robot in it",
        "7 links to devices of atrv1",
        "The robot is up after",
        "A client queries by capability",
        "a drive of 0.5 m/s or faster atrv1/drive",
        "a thermal camera atrv1/thermal",
        "The robot drives a square, and its drive's process is killed",
        "was killed: the driver of the wheels",
        "the script acquired a new one, read the odometry, and finished the square",
        "The pan-tilt unit turns the cameras",
        "6 images are in the report",
        "Comparison with the ground truth",
        "The wheels stopped",
        "The report",
        "processes of this demonstration have ended",
        "Measured",
        "cold start to every device working and shown",
        "drive's last command to the robot standing");

    String html = Files.readString(report().resolve("report.html"));
    assertThat(html).contains("Path", "drive killed", "<img src=\"data:image/png;base64,");
    try (var files = Files.list(report())) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .contains("truth.csv", "atrv1-drive.csv", "atrv1-laser.csv", "atrv1-thermal.csv");
    }
    assertThat(Files.readAllLines(report().resolve("atrv1-odometry.csv")))
        .as("readings of the odometry")
        .hasSizeGreaterThan(100);
  }
}
