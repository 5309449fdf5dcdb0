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
import org.dfra.sim.world.GroundTruthPose;
import org.dfra.sim.world.World;

/**
 * Writes the true pose of every robot as CSV: a row for each robot and time. Confined to one
 * thread.
 */
public final class GroundTruthLog implements Closeable {

  private static final String HEADER =
      "time,robot,east_m,north_m,up_m,yaw_rad,eastward_mps,northward_mps,turn_rate_radps";

  private final World world;
  private final BufferedWriter out;

  /**
   * @param file is overwritten
   */
  public GroundTruthLog(World world, Path file) throws IOException {
    this.world = world;
    this.out = Files.newBufferedWriter(file, StandardCharsets.UTF_8);
    out.write(HEADER);
    out.newLine();
  }

  /** Writes a row for each robot and flushes it to disk. */
  public void write(Instant time) throws IOException {
    for (Map.Entry<String, GroundTruthPose> each : world.groundTruth().poses(time).entrySet()) {
      GroundTruthPose pose = each.getValue();
      out.write(
          String.format(
              Locale.ROOT,
              "%s,%s,%.4f,%.4f,%.4f,%.5f,%.4f,%.4f,%.5f",
              pose.time(),
              each.getKey(),
              pose.east(),
              pose.north(),
              pose.up(),
              pose.yaw(),
              pose.eastward(),
              pose.northward(),
              pose.yawRate()));
      out.newLine();
    }
    out.flush();
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
