package org.dfra.core.behavior;

import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.Goal;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleContext;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Subscription;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;

/** A behaviour whose goals are as near as the test says. */
@Timeout(60)
abstract class GenieFixture {

  static final Duration PATIENCE = Duration.ofSeconds(20);

  /** Something to wish for; null cannot be reached. */
  record Wish(String what) implements Goal {}

  final AtomicInteger rests = new AtomicInteger();
  final AtomicInteger steps = new AtomicInteger();
  private final InMemoryModuleDirectory directory = new InMemoryModuleDirectory();
  final Genie genie = new Genie("genie");

  /** The results of the next cycles; the last one holds for all later cycles. */
  final LinkedBlockingQueue<Object> turns = genie.script;

  final List<BehaviorStatus> published = new CopyOnWriteArrayList<>();

  final class Genie extends BehaviorImpl<Wish> {

    private Object last = GoalProgress.inProgress("it rubs the lamp", 0);

    final LinkedBlockingQueue<Object> script = new LinkedBlockingQueue<>();

    Genie(String name) {
      super(
          new ModuleContext(
                  "atrv1",
                  name,
                  Parameters.of("atrv1/" + name, Map.of("rate", "50")),
                  InstantSource.system())
              .withDirectory(directory),
          "grants wishes",
          "DFRA",
          "1",
          Wish.class,
          10);
    }

    @Override
    protected GoalExecution startGoal(Wish goal) {
      if (goal.what().isEmpty()) {
        throw new GoalRefusedException("a wish for nothing; wish for something");
      }
      return new GoalExecution() {
        @Override
        public GoalProgress step() throws RemoteException {
          steps.incrementAndGet();
          @Nullable Object next = script.poll();
          if (next instanceof Runnable waiting) {
            waiting.run();
            next = null;
          }
          last = next == null ? last : next;
          if (last instanceof RemoteException e) {
            throw e;
          } else if (last instanceof RuntimeException e) {
            throw e;
          } else if (last instanceof Error e) {
            throw e;
          }
          return (GoalProgress) last;
        }

        @Override
        public void suspend() {
          rests.incrementAndGet();
        }
      };
    }
  }

  @BeforeEach
  void start() {
    genie.start();
    Subscription unused =
        genie.subscribe(
            delivery -> {
              if (delivery.event() instanceof ModuleEvent.NewReading fresh) {
                published.add((BehaviorStatus) fresh.reading());
              }
            },
            DeliveryPolicy.keepLast(1000));
  }

  @AfterEach
  void end() {
    genie.close();
    directory.close();
  }

  static void awaitPhase(Genie genie, Phase phase) {
    await().atMost(PATIENCE).until(() -> genie.status().phase() == phase);
  }

  void awaitPublished(String doing) {
    await()
        .atMost(PATIENCE)
        .until(() -> published.stream().anyMatch(status -> status.activity().equals(doing)));
  }
}
