package org.dfra.app.benchmark.attack;

import java.util.Random;
import org.jspecify.annotations.Nullable;

/**
 * Announces a hundred lookup services a second, by multicast, each another one at a port of the
 * attacker's where nobody answers. No datagram leaves this computer.
 */
public final class RogueAnnouncements extends AttackTask {

  private static final long PERIOD_MILLIS = 10;
  private static final int FIRST_PORT = 10_000;
  private static final int PORTS = 10_000;

  private final Random random = new Random(66);
  private @Nullable Announcements announcements;

  /** As every task is made. */
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
