package org.dfra.app.raster.process;

import java.io.Closeable;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.List;
import org.dfra.app.demo.harness.SimulationProcess;
import org.dfra.app.raster.monitor.TrueTrajectory;
import org.dfra.app.raster.monitor.TruthSource;
import org.dfra.sim.world.Collision;
import org.dfra.sim.world.GroundTruthPose;

/**
 * The robots' true poses, read from the file that a simulation in another process writes: a line
 * for each robot and time, the older first. Confined to one thread.
 */
final class TruthFile implements TruthSource, Closeable {

  private static final int COLUMNS = 9;

  private final SimulationProcess simulation;
  private final RandomAccessFile file;
  private String rest = ""; // an incomplete line

  TruthFile(SimulationProcess simulation) throws IOException {
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
      take(text.substring(begin, end), way);
      begin = end + 1;
    }
    rest = text.substring(begin);
  }

  private static void take(String line, TrueTrajectory way) {
    String[] cells = line.strip().split(",", -1);
    if (cells.length == COLUMNS && !cells[0].equals("time")) {
      double[] number = new double[COLUMNS];
      for (int i = 2; i < COLUMNS; i++) {
        number[i] = Double.parseDouble(cells[i]);
      }
      way.add(
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
              number[8]));
    }
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
