package org.dfra.river.discovery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.jini.discovery.Discovery;
import com.sun.jini.discovery.MulticastAnnouncement;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import net.jini.config.ConfigurationException;
import net.jini.constraint.BasicMethodConstraints;
import net.jini.core.constraint.Integrity;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.river.lookup.SuppliedConfiguration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A search that is given announcements, and asks servers of the test. No datagram is sent. */
@Timeout(60)
class MulticastSearchTest {

  private static final String GROUP = "field";
  private static final FakeRegistrar HONEST = new FakeRegistrar(7, GROUP);
  private static final long PATIENCE_SECONDS = 20;

  private final BlockingQueue<String> events = new LinkedBlockingQueue<>();
  private final List<AutoCloseable> ending = new ArrayList<>();
  private MulticastSearch search;

  private final class Recording implements MulticastSearch.Listener {
    @Override
    public void found(ServiceRegistrar registrar) {
      events.add("found " + registrar.getServiceID());
    }

    @Override
    public void lost(ServiceRegistrar registrar) {
      events.add("lost " + registrar.getServiceID());
    }
  }

  @BeforeEach
  void begin() throws Exception {
    NetworkInterface[] none = {};
    search =
        new MulticastSearch(
            new String[] {GROUP},
            new SuppliedConfiguration(
                Map.of(MulticastSettings.COMPONENT + ".multicastInterfaces", () -> none)),
            new Recording());
  }

  @AfterEach
  void end() throws Exception {
    search.close();
    for (AutoCloseable each : ending) {
      each.close();
    }
  }

  private AnsweringServer serve(AnsweringServer.Answering answering) throws IOException {
    AnsweringServer server = new AnsweringServer(answering);
    ending.add(server);
    return server;
  }

  private AnsweringServer serve(FakeRegistrar registrar) throws IOException {
    byte[] answer = AnsweringServer.answer(registrar, List.of(registrar.getGroups()));
    return serve(out -> out.write(answer));
  }

  private void announce(String host, int port, ServiceID id, String... groups) throws IOException {
    DatagramPacket packet =
        Discovery.getProtocol1()
            .encodeMulticastAnnouncement(
                new MulticastAnnouncement(0, host, port, groups, id),
                512,
                InvocationConstraints.EMPTY)
            .next()[0];
    packet.setAddress(InetAddress.getLoopbackAddress());
    search.received(packet);
  }

  private void announce(AnsweringServer server, ServiceID id, String... groups) throws IOException {
    announce(server.host(), server.port(), id, groups);
  }

  private String event() throws InterruptedException {
    return String.valueOf(events.poll(PATIENCE_SECONDS, TimeUnit.SECONDS));
  }

  @Test
  void findsWhatIsAnnouncedOnce() throws Exception {
    AnsweringServer server = serve(HONEST);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
    for (int i = 0; i < 10; i++) {
      announce(server, HONEST.getServiceID(), GROUP);
    }
    assertThat(search.holds(HONEST.getServiceID())).isTrue();
    assertThat(server.asked()).isEqualTo(1);
    assertThat(events).isEmpty();
  }

  @Test
  void asksNoneOfAnotherGroupAndTakesNoneThatIsNotOfTheGroupItAnnounced() throws Exception {
    AnsweringServer other = serve(new FakeRegistrar(8, "yard"));
    AnsweringServer liar = serve(new FakeRegistrar(9, "yard"));
    AnsweringServer server = serve(HONEST);
    announce(other, new ServiceID(0, 8), "yard");
    announce("localhost", liar.port(), new ServiceID(0, 9), GROUP);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
    assertThat(other.asked()).isZero();
    assertThat(search.holds(new ServiceID(0, 9))).isFalse();
  }

  @Test
  void findsAnHonestOneBesideManyThatStall() throws Exception {
    CountDownLatch over = new CountDownLatch(1);
    try {
      AnsweringServer stalling =
          serve(
              out -> {
                try {
                  over.await();
                } catch (InterruptedException e) {
                  throw new IOException(e);
                }
              });
      for (int i = 0; i < 500; i++) {
        announce("localhost", stalling.port(), new ServiceID(1, i), GROUP);
        announce("127.66.0." + i % 250, 1, new ServiceID(2, i), GROUP);
      }
      AnsweringServer server = serve(HONEST);
      long began = System.nanoTime();
      announce(server, HONEST.getServiceID(), GROUP);
      assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
      assertThat(Duration.ofNanos(System.nanoTime() - began)).isLessThan(Duration.ofSeconds(5));
      assertThat(stalling.asked()).isLessThanOrEqualTo(AnnouncedHosts.PROBES);
    } finally {
      over.countDown();
    }
  }

  @Test
  void looksAgainForWhatIsDiscarded() throws Exception {
    AnsweringServer server = serve(HONEST);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).startsWith("found");
    search.discard(HONEST);
    assertThat(search.holds(HONEST.getServiceID())).isFalse();
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
    assertThat(server.asked()).isEqualTo(2);
  }

  @Test
  void losesWhatIsOfNoWantedGroupAnyMore() throws Exception {
    AnsweringServer server = serve(HONEST);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).startsWith("found");
    search.addGroups(new String[] {"yard"});
    search.removeGroups(new String[] {GROUP});
    assertThat(event()).isEqualTo("lost " + HONEST.getServiceID());
    assertThat(search.getGroups()).containsExactly("yard");
    search.setGroups(null);
    assertThat(search.getGroups()).isNull();
    assertThatThrownBy(() -> search.addGroups(new String[] {GROUP}))
        .isInstanceOf(UnsupportedOperationException.class);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
  }

  @Test
  void dropsDatagramsThatAreNoAnnouncements() throws Exception {
    for (byte[] each : List.of(new byte[0], new byte[3], new byte[512], new byte[] {0, 0, 0, 1})) {
      search.received(
          new DatagramPacket(each, each.length, InetAddress.getLoopbackAddress(), 4160));
    }
    announce("a\u001b[2J", 4160, new ServiceID(5, 5), GROUP);
    AnsweringServer server = serve(HONEST);
    announce(server, HONEST.getServiceID(), GROUP);
    assertThat(event()).isEqualTo("found " + HONEST.getServiceID());
  }

  @Test
  void refusesConstraintsThatItCannotFulfil() {
    assertThatThrownBy(
            () ->
                MulticastSettings.of(
                    new SuppliedConfiguration(
                        Map.of(
                            MulticastSettings.COMPONENT + ".discoveryConstraints",
                            () ->
                                new BasicMethodConstraints(
                                    new InvocationConstraints(Integrity.YES, null))))))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("cannot fulfil");
  }
}
