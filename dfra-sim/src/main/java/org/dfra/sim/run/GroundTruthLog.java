package org.dfra.sim.run;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.dfra.sim.world.World;

/**
 * Writes the true pose of every robot as CSV: a row for each robot and time. Confined to one
 * thread.
 */
public final class GroundTruthLog implements Closeable {

  private final World world;
  private final BufferedWriter out;

  /**
   * @param file is overwritten
   */
  public GroundTruthLog(World world, Path file) throws IOException {
    this.world = world;
    this.out = Files.newBufferedWriter(file, StandardCharsets.UTF_8);
    out.write(GroundTruthRow.HEADER);
    out.newLine();
  }

  /** Writes a row for each robot and flushes it to disk. */
  public void write(Instant time) throws IOException {
    for (Map.Entry<String, GroundTruthPose> each : world.groundTruth().poses(time).entrySet()) {
      out.write(new GroundTruthRow(each.getKey(), each.getValue()).line());
      out.newLine();
    }
    out.flush();
  }

  @Override
  public void close() throws IOException {
    out.close();
  }

  /**
   * A row of the file that {@code ./dfra sim run --truth} writes: a robot's true pose at a time.
   * The file has no roll, pitch or vertical velocity; these are 0 in a row that was read.
   *
   * @param robot its name
   * @param pose its pose
   */
  public record GroundTruthRow(String robot, GroundTruthPose pose) {

    static final String HEADER =
        "time,robot,east_m,north_m,up_m,yaw_rad,eastward_mps,northward_mps,yaw_rate_radps";

    private static final int COLUMNS = HEADER.split(",", -1).length;

    /**
     * Reads a line of the file; empty for the headings, and for a last line that is not written
     * completely.
     *
     * @throws IllegalArgumentException if a number cannot be read
     * @throws java.time.DateTimeException if the time cannot be read
     */
    public static Optional<GroundTruthRow> parse(String line) {
      String[] cells = line.strip().split(",", -1);
      if (cells.length != COLUMNS || line.strip().equals(HEADER)) {
        return Optional.empty();
      }
      double[] number = new double[COLUMNS];
      for (int i = 2; i < COLUMNS; i++) {
        number[i] = Double.parseDouble(cells[i]);
      }
      return Optional.of(
          new GroundTruthRow(
              cells[1],
              new GroundTruthPose(
                  Instant.parse(cells[0]),
                  number[2],
                  number[3],
                  number[4],
                  0,
                  0,
                  number[5],
                  number[6],
                  number[7],
                  0,
                  number[8])));
    }

    /** The line of the file. */
    String line() {
      return String.format(
          Locale.ROOT,
          "%s,%s,%.4f,%.4f,%.4f,%.5f,%.4f,%.4f,%.5f",
          pose.time(),
          robot,
          pose.east(),
          pose.north(),
          pose.up(),
          pose.yaw(),
          pose.eastward(),
          pose.northward(),
          pose.yawRate());
    }
  }
}
