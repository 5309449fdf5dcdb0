package org.dfra.attack.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.awaitility.Awaitility.await;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import net.jini.core.entry.Entry;
import net.jini.core.event.EventRegistration;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.event.UnknownEventException;
import net.jini.core.lease.Lease;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.export.Exporter;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.SilentPeer;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.attack.SourceSockets;
import org.dfra.core.time.StallProbe;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Event listeners that never answer hold up neither a lookup service nor its other listeners. */
@Timeout(120)
class EventListenerPreparerTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final Duration LEASE = Duration.ofSeconds(10);

  /** How long a lease is that is to end soon. */
  private static final Duration BRIEF = Duration.ofMillis(500);

  /** The requirement: how long an honest listener waits for an event beside silent ones. */
  private static final Duration DELIVERED = Duration.ofSeconds(1);

  private static final int TRANSITIONS =
      ServiceRegistrar.TRANSITION_MATCH_MATCH
          | ServiceRegistrar.TRANSITION_MATCH_NOMATCH
          | ServiceRegistrar.TRANSITION_NOMATCH_MATCH;

  /** Above reggie's own 50 threads, each of which a silent listener held. */
  private static final int SILENT = 100;

  /** Listeners of one address. */
  private static final int PER_ADDRESS = 128;

  private final AttackHosts hosts = AttackHosts.assumed();
  private final List<RemoteEvent> received = new CopyOnWriteArrayList<>();
  private final RemoteEventListener listener = received::add; // JERI holds it weakly
  private EmbeddedRegistrar reggie;
  private Exporter exporter;
  private RemoteEventListener honest;

  @BeforeEach
  void start() throws Exception {
    reggie =
        new EmbeddedRegistrar(
                hosts.robot(), 0, List.of("attack-" + UUID.randomUUID()), LEASE, Map.of())
            .start();
    exporter =
        new BasicJeriExporter(
            hosts.operatorSockets().serverEndpoint(), new BasicILFactory(), false, false);
    honest = (RemoteEventListener) exporter.export(listener);
  }

  @AfterEach
  void end() throws Exception {
    boolean unused = exporter.unexport(true);
    reggie.close();
  }

  private ServiceRegistrar registrar(SourceSockets sockets) throws Exception {
    return SourceBoundProxies.registrar(hosts.robot(), reggie.port(), sockets);
  }

  private static EventRegistration listen(ServiceRegistrar registrar, RemoteEventListener to)
      throws RemoteException {
    return registrar.notify(
        new ServiceTemplate(null, null, null),
        TRANSITIONS,
        to,
        (MarshalledObject<?>) null,
        LEASE.toMillis());
  }

  private static ServiceRegistration register(ServiceRegistrar registrar, String service)
      throws RemoteException {
    return registrar.register(new ServiceItem(null, service, new Entry[0]), LEASE.toMillis());
  }

  @Test
  void silentListenersHoldUpNoHonestOne() throws Exception {
    ServiceRegistrar operators = registrar(hosts.operatorSockets());
    try (StallProbe probe = StallProbe.start();
        SilentPeer silent = new SilentPeer(hosts.attacker(), 4)) {
      ServiceRegistrar attackers = registrar(hosts.attackerSockets());
      for (int i = 0; i < SILENT; i++) {
        EventRegistration unrenewed = listen(attackers, silent.proxy(RemoteEventListener.class));
        assertThat(unrenewed).isNotNull();
      }
      EventRegistration registration = listen(operators, honest);
      ServiceRegistration first = register(operators, "first"); // the silent ones hold calls now
      await("the first event").atMost(PATIENCE).until(() -> received.size() == 1);
      StallProbe.Stopwatch registered = probe.stopwatch();
      ServiceRegistration second = register(operators, "second");
      await("the second event").atMost(PATIENCE).until(() -> received.size() == 2);
      registered
          .stop()
          .requireWithin("an event of the lookup service beside silent listeners", DELIVERED);
      assertThat(received).extracting(RemoteEvent::getID).containsOnly(registration.getID());
      assertThat(received)
          .extracting(RemoteEvent::getSequenceNumber)
          .containsExactly(
              registration.getSequenceNumber() + 1, registration.getSequenceNumber() + 2);
      assertThat(first.getServiceID()).isNotEqualTo(second.getServiceID());
      assertThat(registrar(hosts.operatorSockets()).getServiceID())
          .as("discovery answers too")
          .isEqualTo(operators.getServiceID());
    }
  }

  @Test
  void oneAddressHasOnlyItsShareOfListenersUntilTheirLeasesEnd() throws Exception {
    try (SilentPeer silent = new SilentPeer(hosts.attacker(), 1)) {
      ServiceRegistrar attackers = registrar(hosts.attackerSockets());
      List<Lease> leases = new ArrayList<>();
      for (int i = 0; i < PER_ADDRESS; i++) {
        leases.add(listen(attackers, silent.proxy(RemoteEventListener.class)).getLease());
      }
      assertThatExceptionOfType(SecurityException.class)
          .isThrownBy(() -> listen(attackers, silent.proxy(RemoteEventListener.class)))
          .withMessageContaining(
              "one more of the listeners of "
                  + hosts.attacker()
                  + " is refused: 128 from that address");
      assertThat(listen(registrar(hosts.operatorSockets()), honest))
          .as("another address is not refused")
          .isNotNull();
      leases.get(0).renew(BRIEF.toMillis()); // reggie grants any that is shorter than its longest
      await("the lease of one of them ends")
          .atMost(PATIENCE)
          .until(() -> isAccepted(attackers, silent.proxy(RemoteEventListener.class)));
    }
  }

  private static boolean isAccepted(ServiceRegistrar registrar, RemoteEventListener to)
      throws RemoteException {
    try {
      return listen(registrar, to) != null;
    } catch (SecurityException e) { // as many as may be, still
      return false;
    }
  }

  @Test
  void aListenerThatWantsNoMoreIsForgottenWithTheNextEvent() throws Exception {
    RemoteEventListener refusing = // JERI holds it weakly
        event -> {
          received.add(event);
          throw new UnknownEventException("no more of these");
        };
    Exporter another =
        new BasicJeriExporter(
            hosts.operatorSockets().serverEndpoint(), new BasicILFactory(), false, false);
    ServiceRegistrar operators = registrar(hosts.operatorSockets());
    EventRegistration registration =
        listen(operators, (RemoteEventListener) another.export(refusing));
    await("the lookup service forgets the listener")
        .atMost(PATIENCE)
        .until(
            () -> {
              register(operators, "next").getLease().cancel();
              return isOver(registration);
            });
    assertThat(received).as("events that the listener got before").isNotEmpty();
    assertThat(another.unexport(true)).isTrue();
    assertThat(refusing).isNotNull();
  }

  private static boolean isOver(EventRegistration registration) throws Exception {
    try {
      registration.getLease().renew(LEASE.toMillis());
      return false;
    } catch (UnknownLeaseException e) {
      return true;
    }
  }
}
