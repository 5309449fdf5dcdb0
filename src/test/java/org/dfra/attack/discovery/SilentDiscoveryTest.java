package org.dfra.attack.discovery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.rmi.MarshalledObject;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.export.Exporter;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.Fakes;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.core.time.StallProbe;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Strangers connect to a registrar's port for discovery and send nothing. Reggie waits a minute for
 * each, on the threads that also answer everybody else and report events.
 */
@Timeout(60)
class SilentDiscoveryTest {

  /** Of each of two attackers; reggie has 50 threads. */
  private static final int SILENT = 60;

  private static final Duration LEASE = Duration.ofSeconds(60);
  private static final Duration BOUND = Duration.ofSeconds(2);

  private final AttackHosts hosts = AttackHosts.assumed();
  private final List<Socket> silent = new ArrayList<>();
  private final List<RemoteEvent> received = new CopyOnWriteArrayList<>();
  private final RemoteEventListener listener = received::add; // JERI holds it weakly
  private EmbeddedRegistrar reggie;
  private Exporter exporter;

  @BeforeEach
  void start() throws Exception {
    reggie = new EmbeddedRegistrar(hosts.robot(), 0, List.of(), LEASE, Map.of()).start();
    exporter =
        new BasicJeriExporter(
            hosts.operatorSockets().serverEndpoint(), new BasicILFactory(), false, false);
  }

  @AfterEach
  void end() throws Exception {
    boolean unused = exporter.unexport(true);
    for (Socket each : silent) {
      each.close();
    }
    reggie.close();
  }

  private void connect(String from) throws IOException {
    Socket socket = new Socket();
    silent.add(socket);
    socket.bind(new InetSocketAddress(from, 0));
    socket.connect(new InetSocketAddress(hosts.robot(), reggie.port()), 10_000);
  }

  @Test
  void silentConnectionsHoldUpNeitherDiscoveryNorEvents() throws Exception {
    RemoteEventListener proxy = (RemoteEventListener) exporter.export(listener);
    long registered =
        SourceBoundProxies.registrar(hosts.robot(), reggie.port(), hosts.operatorSockets())
            .notify(
                new ServiceTemplate(null, null, null),
                ServiceRegistrar.TRANSITION_NOMATCH_MATCH,
                proxy,
                (MarshalledObject<?>) null,
                LEASE.toMillis())
            .getID();
    for (int i = 0; i < SILENT; i++) {
      connect(hosts.attacker());
      connect(hosts.otherAttacker());
    }
    try (StallProbe probe = StallProbe.start()) {
      StallProbe.Stopwatch watch = probe.stopwatch();
      ServiceRegistrar found =
          SourceBoundProxies.registrar(hosts.robot(), reggie.port(), hosts.operatorSockets());
      watch.stop().requireWithin("discovery beside silent connections", BOUND);
      Object unused = Fakes.register(found, null, "honest");
      await("the event").atMost(Duration.ofSeconds(10)).until(() -> !received.isEmpty());
    }
    assertThat(received).extracting(RemoteEvent::getID).containsOnly(registered);
    assertThat(isEnded(silent.get(0))).as("the oldest made room").isTrue();
  }

  private static boolean isEnded(Socket socket) throws IOException {
    socket.setSoTimeout(10_000);
    try {
      return socket.getInputStream().read() < 0;
    } catch (SocketException e) { // it was reset
      return true;
    }
  }
}
