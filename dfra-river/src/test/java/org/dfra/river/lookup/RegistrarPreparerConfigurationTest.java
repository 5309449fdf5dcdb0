package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.security.ProxyPreparer;
import org.dfra.river.discovery.FakeRegistrar;
import org.dfra.river.discovery.LocatedRegistrar;
import org.junit.jupiter.api.Test;

class RegistrarPreparerConfigurationTest {

  private static final String COMPONENT = "net.jini.lookup.JoinManager";

  @Test
  void thePreparerGetsTheProxyAndWhatItReturnsIsTheSameLookupServiceStill() throws Exception {
    FakeRegistrar proxy = new FakeRegistrar(7, "field");
    LocatedRegistrar found = proxy.at("127.0.0.1", 4160);
    AtomicReference<Object> given = new AtomicReference<>();
    ProxyPreparer own =
        object -> {
          given.set(object);
          return new FakeRegistrar(7, "prepared");
        };
    RegistrarPreparerConfiguration configuration =
        new RegistrarPreparerConfiguration(
            new SuppliedConfiguration(Map.of(COMPONENT + ".registrarPreparer", () -> own)));
    ProxyPreparer preparer =
        (ProxyPreparer)
            configuration.getEntry(COMPONENT, "registrarPreparer", ProxyPreparer.class, null);

    Object prepared = preparer.prepareProxy(found);

    assertThat(given.get()).isSameAs(proxy);
    assertThat(prepared).isEqualTo(found).isInstanceOf(LocatedRegistrar.class);
    assertThat(((LocatedRegistrar) prepared).getGroups()).containsExactly("prepared");
  }

  @Test
  void lookupServicesOfOneServiceIdAreEqualOnlyIfTheirProxiesAre() throws Exception {
    LocatedRegistrar found = new FakeRegistrar(7, "field").at("127.0.0.1", 4160);
    assertThat(new FakeRegistrar(7, "field").at("127.0.0.2", 4161)).isEqualTo(found);
    assertThat(new FakeRegistrar(7, "a copy").at("127.0.0.1", 4160)).isNotEqualTo(found);
    assertThat(found.toString()).endsWith(" at 127.0.0.1:4160");
  }
}
