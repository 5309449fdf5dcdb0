package org.dfra.examples.mission.process;

import java.io.Closeable;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.dfra.examples.harness.SimulationProcess;
import org.dfra.examples.mission.monitor.MissionMonitor.TruthSource;
import org.dfra.examples.mission.monitor.TrueTrajectory;
import org.dfra.sim.run.GroundTruthLog.GroundTruthRow;
import org.dfra.sim.world.GroundTruth.Collision;

/**
 * The robots' true poses, read from the file that a simulation in another process writes: a line
 * for each robot and time, the older first. Confined to one thread.
 */
public final class TruthFile implements TruthSource, Closeable {

  private final SimulationProcess simulation;
  private final RandomAccessFile file;
  private String rest = ""; // an incomplete line

  /** Reads the file from its beginning. */
  public TruthFile(SimulationProcess simulation) throws IOException {
    this.simulation = simulation;
    this.file = new RandomAccessFile(simulation.truth().toFile(), "r");
  }

  @Override
  public void readNew(TrueTrajectory way) throws IOException {
    if (!simulation.isAlive()) {
      throw new IOException("the simulated world has ended; see simulation.log");
    }
    byte[] fresh =
        new byte[(int) Math.min(Integer.MAX_VALUE, file.length() - file.getFilePointer())];
    file.readFully(fresh);
    String text = rest + new String(fresh, StandardCharsets.US_ASCII);
    int begin = 0;
    for (int end = text.indexOf('\n'); end >= 0; end = text.indexOf('\n', begin)) {
      GroundTruthRow.parse(text.substring(begin, end))
          .ifPresent(row -> way.add(row.robot(), row.pose()));
      begin = end + 1;
    }
    rest = text.substring(begin);
  }

  @Override
  public List<Collision> collisions() {
    return simulation.collisions();
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
