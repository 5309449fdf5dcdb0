package org.dfra.robot;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.jini.thread.ReadersWriter;
import java.lang.reflect.Method;
import java.rmi.MarshalledObject;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.LongUnaryOperator;
import net.jini.core.entry.Entry;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseMap;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.tcp.TcpServerEndpoint;
import net.jini.lookup.entry.Name;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.registrar.ReggieFields;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * The system clock of a lookup service was set back by an hour: its leases have an hour left until
 * they are shortened. A renewal in between grants no more than the longest lease.
 */
class RenewalAfterClockStepTest {

  private static final Duration LONGEST = Duration.ofMinutes(5);
  private static final long HOUR_MILLIS = Duration.ofHours(1).toMillis();

  private final EmbeddedRegistrar registrar =
      new EmbeddedRegistrar("127.0.0.1", 0, List.of(), LONGEST, Map.of());
  private final BasicJeriExporter exporter =
      new BasicJeriExporter(TcpServerEndpoint.getInstance("127.0.0.1", 0), new BasicILFactory());

  private ServiceRegistrar proxy;
  private Lease service;
  private Lease listener;

  @BeforeEach
  void register() throws Exception {
    proxy = registrar.start().registrar();
    ServiceItem item = new ServiceItem(null, "a proxy", new Entry[] {new Name("drive")});
    service = proxy.register(item, Lease.FOREVER).getLease();
    RemoteEventListener called = (RemoteEventListener) exporter.export(new Silent());
    listener =
        proxy
            .notify(
                new ServiceTemplate(null, null, new Entry[] {new Name("arm")}),
                ServiceRegistrar.TRANSITION_NOMATCH_MATCH,
                called,
                new MarshalledObject<>("handback"),
                Lease.FOREVER)
            .getLease();
  }

  private static final class Silent implements RemoteEventListener {
    @Override
    public void notify(net.jini.core.event.RemoteEvent event) {
      throw new AssertionError("no service matches: " + event);
    }
  }

  @AfterEach
  void end() throws Exception {
    boolean unused = exporter.unexport(true);
    registrar.close();
  }

  @Test
  void oneLease() throws Exception {
    for (Lease each : List.of(service, listener)) {
      moveEnds(end -> end + HOUR_MILLIS);
      each.renew(Lease.FOREVER);
      assertThat(each.getExpiration() - System.currentTimeMillis())
          .as("ms granted to " + each)
          .isPositive()
          .isLessThanOrEqualTo(LONGEST.toMillis());
    }
  }

  @Test
  void severalLeasesAtOnce() throws Exception {
    moveEnds(end -> end + HOUR_MILLIS);
    LeaseMap together = service.createLeaseMap(Lease.FOREVER);
    assertThat(together.canContainKey(listener)).isTrue();
    together.put(listener, Lease.FOREVER);
    together.renewAll();
    for (Lease each : List.of(service, listener)) {
      assertThat(each.getExpiration() - System.currentTimeMillis())
          .as("ms granted to " + each)
          .isPositive()
          .isLessThanOrEqualTo(LONGEST.toMillis());
    }
  }

  /** What reggie sees if its clock is moved instead. */
  private void moveEnds(LongUnaryOperator moved) throws Exception {
    Object running = ReggieFields.accessible(EmbeddedRegistrar.class, "running").get(registrar);
    Method accessor = running.getClass().getDeclaredMethod("reggie");
    accessor.setAccessible(true);
    Object reggie = accessor.invoke(running);
    Class<?> type = ReggieFields.owner(reggie);
    ReadersWriter lock = (ReadersWriter) ReggieFields.accessible(type, "concurrentObj").get(reggie);
    lock.writeLock();
    try {
      for (String each : List.of("serviceByID", "eventByID")) {
        Map<?, ?> registrations = (Map<?, ?>) ReggieFields.accessible(type, each).get(reggie);
        for (Object registration : new ArrayList<>(registrations.values())) {
          var end = ReggieFields.accessible(registration.getClass(), "leaseExpiration");
          if (end.getLong(registration) != Long.MAX_VALUE) { // reggie's own
            end.setLong(registration, moved.applyAsLong(end.getLong(registration)));
          }
        }
      }
    } finally {
      lock.writeUnlock();
    }
  }
}
