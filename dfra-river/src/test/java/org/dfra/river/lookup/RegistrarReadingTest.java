package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.module.Readiness;
import org.dfra.persona.ModuleAttributes;
import org.dfra.river.entry.Entries;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What is read of a lookup service for an emergency. */
@Timeout(60)
class RegistrarReadingTest {

  private final BlockingQueue<ListedEffector> found = new LinkedBlockingQueue<>();

  private final EffectorSearch.Listener listener =
      new EffectorSearch.Listener() {
        @Override
        public void registrarAt(UUID registrar, String host) {}

        @Override
        public void found(ListedEffector effector) {
          found.add(effector);
        }
      };

  /** One that claims the same service ID as every other one, and lists one effector. */
  private static ServiceRegistrar registrar() {
    ModuleAttributes drive =
        new ModuleAttributes(
            "atrv1",
            "drive",
            "org.example.Driver",
            "127.0.0.1",
            "DFRA",
            "1.0",
            Readiness.READY,
            Instant.EPOCH,
            null,
            0);
    ServiceItem item = new ServiceItem(new ServiceID(0, 99), null, Entries.of(List.of(drive)));
    return (ServiceRegistrar)
        Proxy.newProxyInstance(
            ServiceRegistrar.class.getClassLoader(),
            new Class<?>[] {ServiceRegistrar.class},
            (proxy, method, args) ->
                switch (method.getName()) {
                  case "getServiceID" -> new ServiceID(0, 7);
                  case "lookup" -> new ServiceMatches(new ServiceItem[] {item}, 1);
                  default -> null;
                });
  }

  private RegistrarReading reading() {
    return new RegistrarReading(registrar(), List.of("atrv1"), List.of(), listener, null, () -> {});
  }

  @Test
  void whatLookupServicesOfOneServiceIdListIsKeptApart() throws Exception {
    try (RegistrarReading one = reading();
        RegistrarReading two = reading()) {
      one.start();
      two.start();
      ListedEffector first = found.poll(30, TimeUnit.SECONDS);
      ListedEffector second = found.poll(30, TimeUnit.SECONDS);
      assertThat(first).isNotNull();
      assertThat(second).isNotNull();
      assertThat(first.id()).isEqualTo(second.id());
      assertThat(first.registrar())
          .as("or only one would be called")
          .isNotEqualTo(second.registrar());
    }
  }
}
