package org.dfra.examples.devices;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.ReportHead;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.report.plot.Axis;
import org.dfra.report.plot.HtmlReport;
import org.dfra.report.plot.LinePanel;
import org.dfra.report.plot.Page;
import org.dfra.report.plot.PathPanel;
import org.dfra.report.plot.Series;

/** Writes the recordings: a page with plots of every stream, and every number as CSV. */
final class DevicesReport {

  private static final Axis TIME = Axis.of("time", "s");

  private final DeviceRecorders streams;
  private final GroundTruthTrack truth;
  private final double killed; // seconds
  private final HtmlReport html;

  /**
   * @param begin when the demonstration started
   * @param killed when the drive's group was killed
   */
  DevicesReport(DeviceRecorders streams, GroundTruthTrack truth, Instant begin, Instant killed) {
    this.streams = streams;
    this.truth = truth;
    this.killed = Duration.between(begin, killed).toNanos() / 1e9;
    this.html = new HtmlReport("One robot, all its devices");
  }

  /**
   * Writes it.
   *
   * @param photos images taken with the head turned, each with its caption
   * @return the file to open
   */
  Path write(Path folder, List<MeasuredValue> figures, List<CapturedImage> photos, Path truthCsv)
      throws IOException {
    Files.createDirectories(folder);
    streams.write(folder);
    Files.copy(
        truthCsv, folder.resolve("truth.csv"), java.nio.file.StandardCopyOption.REPLACE_EXISTING);
    head(figures);
    html.paragraph(
        "A robot of the simulated world drove a square of "
            + String.format(Locale.ROOT, "%.0f m", SquareScript.SIDE)
            + " by a script. Each emulated device used its byte protocol with its real driver, in a"
            + " service group of its own under phoenix (mode: processes; the seed determines world"
            + " and noise, not scheduling). The process that drives the wheels was killed on the"
            + " second side.");
    html.heading("Path").figure(paths(), "The square: true path, odometry, and GPS.");
    html.heading("Commands and motion").figure(motion(), "Motion over time.");
    html.heading("Laser")
        .figure(
            laser(), "Ends of the beams, placed by the odometry at that time; with ghost echoes.");
    html.heading("Cameras");
    for (CapturedImage photo : photos) {
      html.image(png(photo.image()), "image/png", photo.caption());
    }
    html.heading("The other streams")
        .figure(others(), "GPS, battery, pan-tilt unit and laser over time.");
    html.heading("Every stream");
    streamTable();
    Path file = folder.resolve("report.html");
    html.write(file);
    return file;
  }

  /**
   * An image taken during the run.
   *
   * @param caption what it shows
   */
  record CapturedImage(CameraImage image, String caption) {}

  private void head(List<MeasuredValue> figures) {
    RunMeasurements all = new RunMeasurements();
    figures.forEach(all::add);
    ReportHead.add(html, all, Instant.now());
  }

  private Page paths() {
    double[][] odometry = streams.odometry.series("x_m");
    double[][] across = streams.odometry.series("y_m");
    double[][] placed = truth.place(odometry[1], across[1]);
    return new Page("The square")
        .row(
            520,
            new PathPanel("Field", Axis.of("east", "m"), Axis.of("north", "m"))
                .addPath(Series.line("true", truth.east(), truth.north()))
                .addPath(Series.line("odometry", placed[0], placed[1]))
                .add(
                    Series.points(
                        "GPS fixes",
                        streams.gps.series("east_m")[1],
                        streams.gps.series("north_m")[1])));
  }

  private Page motion() {
    double[][] reported = streams.drive.series("speed_mps");
    double[][] wheels = streams.odometry.series("speed_mps");
    double[][] gyro = streams.gyro.series("rate_radps");
    double[][] turning = streams.odometry.series("yaw_rate_radps");
    return new Page("Motion")
        .row(
            260,
            new LinePanel("Speed", TIME, Axis.of("speed", "m/s"))
                .add(
                    Series.steps("commanded", reported[0], reported[1]),
                    Series.line("odometry", wheels[0], wheels[1]),
                    Series.line("true", truth.seconds(), truth.speed()))
                .moment(killed, "drive killed"))
        .row(
            260,
            new LinePanel("Yaw rate", TIME, Axis.of("rate", "rad/s"))
                .add(
                    Series.line("gyro", gyro[0], gyro[1]),
                    Series.line("odometry", turning[0], turning[1]))
                .moment(killed, "drive killed"));
  }

  private Page laser() {
    double[][] points = streams.map.points();
    double[][] placed = truth.place(points[0], points[1]);
    return new Page("Laser")
        .row(
            520,
            new PathPanel("Ends of beams", Axis.of("east", "m"), Axis.of("north", "m"))
                .add(Series.points("beams", placed[0], placed[1]))
                .addPath(Series.line("the robot, true", truth.east(), truth.north())));
  }

  private Page others() {
    double[][] voltage = streams.battery.series("voltage_v");
    double[][] pan = streams.panTilt.series("pan_rad");
    double[][] tilt = streams.panTilt.series("tilt_rad");
    double[][] nearest = streams.laser.series("nearest_m");
    double[][] satellites = streams.gps.series("satellites");
    return new Page("The other streams")
        .row(
            230,
            new LinePanel("Nearest object", TIME, Axis.of("range", "m"))
                .add(Series.line("laser", nearest[0], nearest[1])),
            new LinePanel("Battery", TIME, Axis.of("voltage", "V"))
                .add(Series.line("terminals", voltage[0], voltage[1])))
        .row(
            230,
            new LinePanel("Head", TIME, Axis.of("angle", "rad"))
                .add(Series.line("pan", pan[0], pan[1]), Series.line("tilt", tilt[0], tilt[1])),
            new LinePanel("Satellites", TIME, Axis.of("tracked", ""))
                .add(Series.steps("GPS", satellites[0], satellites[1])));
  }

  private void streamTable() {
    List<List<String>> rows = new ArrayList<>();
    for (ReadingRecorder<?> each : streams.all()) {
      rows.add(
          List.of(
              each.path(),
              each.type(),
              Long.toString(each.count()),
              String.format(Locale.ROOT, "%.1f Hz", each.rate()),
              String.format(Locale.ROOT, "%.2f s", each.longestGap()),
              Long.toString(each.lost())));
    }
    html.table(
        List.of("Module", "Readings", "Received", "Rate", "Longest gap", "Lost events"), rows);
  }

  /**
   * As an image for browsers: a thermal image is stretched from its coldest to its warmest value.
   */
  private static byte[] png(CameraImage image) throws IOException {
    BufferedImage decoded = ImageIO.read(new ByteArrayInputStream(image.data()));
    if (decoded == null) {
      throw new IOException("an image of " + image.frame() + " cannot be decoded");
    }
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ImageIO.write(
        image.band() == CameraImage.Band.THERMAL ? stretched(decoded) : decoded, "png", out);
    return out.toByteArray();
  }

  private static BufferedImage stretched(BufferedImage heat) {
    int width = heat.getWidth();
    int height = heat.getHeight();
    int[] levels = heat.getRaster().getSamples(0, 0, width, height, 0, (int[]) null);
    int coldest = Integer.MAX_VALUE;
    int warmest = Integer.MIN_VALUE;
    for (int level : levels) {
      coldest = Math.min(coldest, level);
      warmest = Math.max(warmest, level);
    }
    BufferedImage grey = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_GRAY);
    int span = Math.max(1, warmest - coldest);
    for (int i = 0; i < levels.length; i++) {
      levels[i] = (levels[i] - coldest) * 255 / span;
    }
    grey.getRaster().setSamples(0, 0, width, height, 0, levels);
    return grey;
  }
}
