package org.dfra.river.discovery;

import static org.assertj.core.api.Assertions.assertThat;

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
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import net.jini.config.ConfigurationException;
import net.jini.core.constraint.InvocationConstraints;
import org.dfra.river.lookup.SuppliedConfiguration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Several searches of one virtual machine share sockets and threads, and disturb nobody. */
@Timeout(60)
class SharedMulticastSearchTest {

  private static final long PATIENCE_SECONDS = 20;

  /** Announced hosts differ between tests, so that these never share a search by accident. */
  private final Duration interval = Duration.ofMillis(100_000 + System.nanoTime() % 100_000);

  private final List<AutoCloseable> ending = new ArrayList<>();

  /** A search and what it has reported. */
  private final class Searcher implements MulticastSearch.Listener {

    private final BlockingQueue<String> events = new LinkedBlockingQueue<>();
    private final MulticastSearch search;
    private volatile LocatedRegistrar last;

    Searcher(String... groups) throws IOException, ConfigurationException {
      NetworkInterface[] none = {};
      String component = MulticastSettings.COMPONENT;
      search =
          MulticastSearch.start(
              groups,
              new SuppliedConfiguration(
                  Map.of(
                      component + ".multicastInterfaces",
                      () -> none,
                      component + ".multicastAnnouncementInterval",
                      interval::toMillis)),
              this);
      ending.add(search);
    }

    @Override
    public void found(LocatedRegistrar registrar) {
      last = registrar;
      events.add("found " + registrar.getServiceID());
    }

    @Override
    public void lost(LocatedRegistrar registrar) {
      events.add("lost " + registrar.getServiceID());
    }

    String event() throws InterruptedException {
      return String.valueOf(events.poll(PATIENCE_SECONDS, TimeUnit.SECONDS));
    }

    /** Hands a datagram to the search that it shares. */
    void announce(AnsweringServer server, FakeRegistrar registrar, String... groups)
        throws IOException {
      DatagramPacket packet =
          Discovery.getProtocol1()
              .encodeMulticastAnnouncement(
                  new MulticastAnnouncement(
                      0, server.host(), server.port(), groups, registrar.getServiceID()),
                  512,
                  InvocationConstraints.EMPTY)
              .next()[0];
      packet.setAddress(InetAddress.getLoopbackAddress());
      search.received(packet);
    }
  }

  @AfterEach
  void end() throws Exception {
    for (AutoCloseable each : ending) {
      each.close();
    }
  }

  private AnsweringServer serve(FakeRegistrar registrar, String... groups) throws IOException {
    byte[] answer = AnsweringServer.answer(registrar, List.of(groups));
    AnsweringServer server = new AnsweringServer(out -> out.write(answer));
    ending.add(server);
    return server;
  }

  private static String found(FakeRegistrar registrar) {
    return "found " + registrar.getServiceID();
  }

  private static String lost(FakeRegistrar registrar) {
    return "lost " + registrar.getServiceID();
  }

  private static long timers() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(each -> each.getName().startsWith("dfra-discovery-timer"))
        .count();
  }

  @Test
  void haveOneTimerAndOneProbe() throws Exception {
    long before = timers();
    Searcher one = new Searcher("field");
    FakeRegistrar registrar = new FakeRegistrar(7, "field");
    AnsweringServer server = serve(registrar, "field");
    one.announce(server, registrar, "field");
    assertThat(one.event()).isEqualTo(found(registrar));
    for (int i = 0; i < 30; i++) {
      assertThat(new Searcher("field").event()).as("to a later one").isEqualTo(found(registrar));
    }
    assertThat(server.asked()).as("queries").isEqualTo(1);
    assertThat(timers()).as("timers").isEqualTo(before + 1);
  }

  @Test
  void reportTheirOwnGroupsOnly() throws Exception {
    Searcher field = new Searcher("field");
    Searcher yard = new Searcher("yard");
    FakeRegistrar inField = new FakeRegistrar(7, "field");
    FakeRegistrar inBoth = new FakeRegistrar(8, "both");
    AnsweringServer one = serve(inField, "field");
    yard.announce(one, inField, "field"); // to both: they share
    assertThat(field.event()).isEqualTo(found(inField));
    field.announce(serve(inBoth, "field", "yard"), inBoth, "field", "yard");
    assertThat(field.event()).isEqualTo(found(inBoth));
    assertThat(yard.event()).as("the only one in its group").isEqualTo(found(inBoth));
    yard.search.addGroups(new String[] {"field"});
    assertThat(yard.event()).as("found by another before").isEqualTo(found(inField));
    yard.search.setGroups(new String[] {"yard"});
    assertThat(yard.event()).isEqualTo(lost(inField));
    assertThat(field.search.isDiscovered(inField.getServiceID())).isTrue();
    assertThat(yard.search.isDiscovered(inField.getServiceID())).isFalse();
    assertThat(field.events).isEmpty();
    assertThat(one.asked()).as("queries of the first").isEqualTo(1);
  }

  @Test
  void discardForThemselvesOnly() throws Exception {
    Searcher one = new Searcher("field");
    Searcher other = new Searcher("field");
    FakeRegistrar registrar = new FakeRegistrar(7, "field");
    AnsweringServer server = serve(registrar, "field");
    one.announce(server, registrar, "field");
    assertThat(one.event()).isEqualTo(found(registrar));
    assertThat(other.event()).isEqualTo(found(registrar));
    one.search.discard(one.last);
    assertThat(one.search.isDiscovered(registrar.getServiceID())).isFalse();
    assertThat(other.search.isDiscovered(registrar.getServiceID())).isTrue();
    assertThat(one.event()).as("it answers the second query").isEqualTo(found(registrar));
    assertThat(server.asked()).as("queries").isEqualTo(2);
    assertThat(other.events).as("nothing to the other").isEmpty();
  }

  @Test
  void goOnWhenAnotherEnds() throws Exception {
    long before = timers();
    Searcher one = new Searcher("field");
    Searcher other = new Searcher("yard");
    one.search.close();
    one.search.close(); // does nothing
    FakeRegistrar registrar = new FakeRegistrar(7, "yard");
    other.announce(serve(registrar, "yard"), registrar, "yard");
    assertThat(other.event()).isEqualTo(found(registrar));
    one.search.setGroups(new String[] {"yard"}); // too late
    assertThat(one.search.isDiscovered(registrar.getServiceID())).isFalse();
    other.search.close();
    assertThat(timers()).as("timers, when all have ended").isLessThanOrEqualTo(before + 1);
    Searcher later = new Searcher("yard");
    later.announce(serve(registrar, "yard"), registrar, "yard");
    assertThat(later.event()).as("by a search of its own").isEqualTo(found(registrar));
  }
}
