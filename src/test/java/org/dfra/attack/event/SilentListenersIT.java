package org.dfra.attack.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.SilentPeer;
import org.dfra.attack.kit.Victim;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.attack.SourceSockets;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.Subscription;
import org.dfra.example.thermometer.RemoteThermometer;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.module.NotReadyException;
import org.dfra.river.remote.RemoteModuleListener;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * A thousand listeners that never answer (in the everyday tier 300) cost a module few threads and
 * its listeners no event.
 */
@Timeout(180)
class SilentListenersIT {

  private static final int LISTENERS = Boolean.getBoolean("dfra.full") ? 1000 : 300;
  private static final int SOCKETS = 40;

  /** Listeners of one address at a module; see docs/concepts/events-and-leases.md. */
  private static final int PER_ADDRESS = 128;

  /** Calls of two deadlines each, and some. */
  private static final Duration ATTACK = Duration.ofSeconds(6);

  /** How long an honest listener may wait for an event. */
  private static final Duration DELIVERED = Duration.ofSeconds(1);

  /** JERI keeps a thread for each process it was connected to, for 15 to 30 s. */
  private static final int LINGERING = 24;

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final AttackHosts hosts = AttackHosts.assumed();

  @Test
  void manySilentListenersCostFewThreadsAndNoHonestEvent() throws Exception {
    try (TaskProcess robot = TaskProcess.start(ServePulse.class, hosts.robot());
        SilentPeer silent = new SilentPeer(hosts.attacker(), SOCKETS)) {
      int port = Integer.parseInt(robot.awaitLine("serves ", PATIENCE).substring(7));
      List<Duration> latencies = new CopyOnWriteArrayList<>();
      try (Subscription honest =
          proxy(port, hosts.operatorSockets())
              .subscribe(
                  delivery -> latencies.add(Duration.between(delivery.published(), Instant.now())),
                  DeliveryPolicy.keepLast(100))) {
        await("an event before the attack").atMost(PATIENCE).until(() -> !latencies.isEmpty());
        Victim victim = Victim.of(robot.pid());

        RemoteThermometer attacked =
            SourceBoundProxies.of(
                SourceBoundProxies.remote(
                    proxy(port, hosts.attackerSockets()), RemoteThermometer.class),
                hosts.attackerSockets());
        int accepted = 0;
        List<String> refusals = new ArrayList<>();
        for (int i = 0; i < LISTENERS; i++) {
          try {
            Subscription unrenewed =
                attacked.subscribe(
                    silent.proxy(RemoteModuleListener.class), DeliveryPolicy.latestReading());
            assertThat(unrenewed).isNotNull();
            accepted++;
          } catch (NotReadyException e) {
            refusals.add(String.valueOf(e.getMessage()));
          }
        }
        assertThat(accepted).as("silent listeners of one address").isBetween(1, PER_ADDRESS);
        assertThat(refusals).allSatisfy(each -> assertThat(each).contains(" of at most "));

        latencies.clear();
        int most = mostThreads(victim);
        assertThat(most).as("threads above before").isLessThan(Victim.THREADS);
        victim.assertWithinLimits();
        assertThat(latencies).as("events at the honest listener").hasSizeGreaterThan(10);
        assertThat(latencies).allSatisfy(each -> assertThat(each).isLessThan(DELIVERED));
        assertThat(honest.lost()).as("events that the honest listener lost").isZero();

        await("the silent listeners are dropped, and others may come")
            .atMost(PATIENCE)
            .until(() -> isAccepted(attacked, silent));
        victim.assertRecovers(LINGERING, Victim.HEAP);
      }
    }
  }

  /** Looks at the victim's threads for as long as the attack lasts. */
  private static int mostThreads(Victim victim) {
    List<Integer> seen = new ArrayList<>();
    long end = System.nanoTime() + ATTACK.toNanos();
    BooleanSupplier isOver = () -> System.nanoTime() - end > 0;
    await()
        .atMost(PATIENCE)
        .pollInterval(Duration.ofMillis(50))
        .until(
            () -> {
              seen.add(victim.moreThreads());
              return isOver.getAsBoolean();
            });
    return seen.stream().mapToInt(Integer::intValue).max().orElseThrow();
  }

  private static boolean isAccepted(RemoteThermometer attacked, SilentPeer silent)
      throws RemoteException {
    try {
      Subscription unrenewed =
          attacked.subscribe(
              silent.proxy(RemoteModuleListener.class), DeliveryPolicy.latestReading());
      return unrenewed != null;
    } catch (NotReadyException e) { // as many as may be, still
      return false;
    }
  }

  /** The module's proxy, found and called from an address. */
  private ThermometerProxy proxy(int port, SourceSockets sockets) throws Exception {
    ServiceRegistrar registrar = SourceBoundProxies.registrar(hosts.robot(), port, sockets);
    ServiceTemplate template = new ServiceTemplate(null, new Class<?>[] {Thermometer.class}, null);
    await("the module is listed")
        .atMost(PATIENCE)
        .until(() -> registrar.lookup(template) instanceof ThermometerProxy);
    return SourceBoundProxies.of((ThermometerProxy) registrar.lookup(template), sockets);
  }
}
