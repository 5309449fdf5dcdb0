package org.dfra.river.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.export.Exporter;
import net.jini.export.ServerContext;
import net.jini.id.UuidFactory;
import net.jini.io.context.ClientHost;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.core.config.Parameters;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.event.DeliveryPolicy;
import org.dfra.module.NotReadyException;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.contract.ScriptedGps;
import org.dfra.river.fixture.SteppedTime;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.remote.GrantedSubscription;
import org.dfra.river.remote.RemoteModuleListener;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** How many listeners a client may have at a module; none is called here. */
class RemoteListenerRegistryTest {

  private static final String ROBOT = "127.1.1.10";
  private static final String STRANGER = "127.1.1.66";
  private static final String OTHER = "127.1.1.67";

  /** Listeners of one address at a module; see docs/concepts/events-and-leases.md. */
  private static final int PER_ADDRESS = 128;

  /** The landlord is called in this virtual machine only. */
  private static final class LocalExporter implements Exporter {

    @Override
    public Remote export(Remote impl) {
      return impl;
    }

    @Override
    public boolean unexport(boolean force) {
      return true;
    }
  }

  /** Its time is stepped, so no lease ends by itself. */
  private final ScriptedGps driver =
      new ScriptedGps(
          new ModuleContext(
              "atrv1",
              "gps_of_many",
              Parameters.of("atrv1/gps_of_many", Map.of()),
              InstantSource.system(),
              StateStore.inMemory(),
              LeaseTerms.DEFAULT,
              new SteppedTime()));

  private final ModuleLandlord landlord =
      new ModuleLandlord("atrv1/gps_of_many", driver.leases(), new LocalExporter(), ROBOT);

  private final RemoteListenerRegistry listeners =
      new RemoteListenerRegistry(driver, landlord, ROBOT);

  @BeforeEach
  void start() throws RemoteException {
    landlord.start();
  }

  @AfterEach
  void end() {
    landlord.close();
    driver.close();
  }

  /** A client at an address subscribes one more listener, always of the same process. */
  private GrantedSubscription subscribe(String client) throws UnknownHostException {
    InetAddress address = InetAddress.getByName(client);
    RemoteModuleListener listener =
        (RemoteModuleListener)
            DeadlineILFactory.proxy(
                new BasicObjectEndpoint(
                    Endpoints.tcpClient(client, 7001), UuidFactory.generate(), false),
                Duration.ofSeconds(2),
                RemoteModuleListener.class.getClassLoader(),
                RemoteModuleListener.class);
    AtomicReference<GrantedSubscription> granted = new AtomicReference<>();
    ServerContext.doWithServerContext(
        () -> granted.set(listeners.add(listener, DeliveryPolicy.latestReading())),
        List.of((ClientHost) () -> address));
    return granted.get();
  }

  @Test
  void anAddressHasOnlySoManyListenersAtAModule() throws Exception {
    List<GrantedSubscription> held = new ArrayList<>();
    for (int i = 0; i < PER_ADDRESS; i++) {
      held.add(subscribe(STRANGER));
    }
    assertThatThrownBy(() -> subscribe(STRANGER))
        .isInstanceOf(NotReadyException.class)
        .hasMessageContaining(
            "listeners of atrv1/gps_of_many: 127.1.1.66 holds 128 of at most 128");
    assertThat(driver.events().entries()).hasSize(PER_ADDRESS);

    assertThat(subscribe(OTHER)).as("another address").isNotNull();
    held.get(0).close();
    assertThat(subscribe(STRANGER)).as("in place of one that was closed").isNotNull();
    assertThatThrownBy(() -> subscribe(STRANGER)).isInstanceOf(NotReadyException.class);
  }
}
