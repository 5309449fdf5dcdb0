package org.dfra.benchmarks.attack;

import java.util.Random;
import org.jspecify.annotations.Nullable;

/**
 * Announces a hundred different lookup services per second by multicast, at a port of the attacker
 * where no server answers. The datagrams do not leave this computer.
 */
public final class RogueAnnouncements extends AttackTask {

  private static final long PERIOD_MILLIS = 10;
  private static final int FIRST_PORT = 10_000;
  private static final int PORTS = 10_000;

  private final Random random = new Random(66);
  private @Nullable Announcements announcements;

  /** Called by {@code TaskMain} by reflection. */
  public RogueAnnouncements() {}

  @Override
  protected void prepare(Target target) throws Exception {
    announcements = new Announcements(target.registrar().getGroups());
  }

  @Override
  protected void attack(Target target) {
    Announcements prepared = announcements;
    if (prepared == null) {
      throw new IllegalStateException("not prepared");
    }
    while (!isStopping()) {
      int port = FIRST_PORT + random.nextInt(PORTS);
      for (int i = 0; i < 100 && !isStopping(); i++) {
        var unused = attempt(() -> prepared.send(target.source(), port));
        pause(PERIOD_MILLIS);
      }
    }
  }
}
