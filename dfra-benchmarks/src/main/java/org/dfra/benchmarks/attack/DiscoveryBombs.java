package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.report.measurement.MeasuredValue;
import org.jspecify.annotations.Nullable;

/**
 * Announces lookup services by multicast that answer unicast discovery with {@linkplain BombServer
 * malicious responses}: a few hundred bytes that claim more memory than the robot has. The
 * datagrams do not leave this computer.
 *
 * <p>A rejected response counts as a refused call. An accepted one exhausts the robot's memory and
 * ends its process.
 */
public final class DiscoveryBombs extends AttackTask {

  private static final int SERVERS = 32;
  private static final long PERIOD_MILLIS = 10;

  private final List<BombServer> servers = new ArrayList<>();
  private @Nullable Announcements announcements;
  private int counted;

  /** Called by {@code TaskMain} by reflection. */
  public DiscoveryBombs() {}

  @Override
  protected void prepare(Target target) throws Exception {
    announcements = new Announcements(target.registrar().getGroups());
    List<byte[]> bombs = List.of(BombServer.claimOfGroups(), BombServer.claimOfNumbers());
    for (int i = 0; i < SERVERS; i++) {
      servers.add(
          BombServer.start(target.source(), target.registrarPort(), bombs, Integer.MAX_VALUE));
    }
  }

  @Override
  protected void attack(Target target) throws IOException {
    Announcements prepared = announcements;
    if (prepared == null) {
      throw new IllegalStateException("not prepared");
    }
    for (BombServer each : servers) {
      if (isStopping()) {
        return;
      }
      int unused = prepared.send(target.source(), each.port());
      pause(PERIOD_MILLIS);
      for (int now = thrown(); counted < now; counted++) {
        countRefused("an answer to discovery that claims more than there is");
      }
    }
  }

  private int thrown() {
    return servers.stream().mapToInt(BombServer::sentCount).sum();
  }

  /**
   * {@inheritDoc}
   *
   * @throws IOException if the robot contacted none of the servers: then it was not attacked
   */
  @Override
  protected void end(Target target) throws IOException {
    if (counted == 0) {
      throw new IOException("the robot asked none of the lookup services that were announced");
    }
  }

  @Override
  protected List<MeasuredValue> figures() {
    return List.of(
        new MeasuredValue("bombs thrown as answers", counted, Double.POSITIVE_INFINITY, ""));
  }
}
