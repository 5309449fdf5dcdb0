package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.UUID;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import org.dfra.core.directory.CachedModuleDirectory;
import org.dfra.core.directory.ModuleTable;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.directory.Persona;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.Module;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.river.discovery.FakeRegistrar;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.entry.Entries;
import org.dfra.river.lookup.JiniModuleDirectory.ModuleConflict;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What counts where several lookup services list different modules under one service ID. */
class ServiceTableTest {

  private static final ServiceID ID = new ServiceID(0, 99);
  private static final Instant VOUCHED = Instant.parse("2026-11-21T12:00:00Z");

  private final Directory directory = new Directory();
  private final ServiceTable serviceTable =
      new ServiceTable(directory.known(), (id, attributes) -> Locality.REMOTE);
  private final RemoteModule server = server();
  private final RemoteModule otherServer = server();
  private LocatedRegistrar honest;
  private LocatedRegistrar stranger;

  private static final class Directory extends CachedModuleDirectory {

    Directory() {
      super(InstantSource.system());
    }

    ModuleTable known() {
      return table();
    }
  }

  /** A proxy as modules have it: equal to every other one of its service ID. */
  private static final class Gps extends ModuleProxy<Module> {

    private static final long serialVersionUID = 1L;

    Gps(RemoteModule server) {
      super(
          Module.class,
          server,
          ServiceTable.uuid(ID),
          new Identification("atrv1", "gps", "a receiver", "DFRA", "1.0"));
    }
  }

  @BeforeEach
  void find() throws IOException {
    honest = new FakeRegistrar(7, "field").at("127.0.0.1", 4160);
    stranger = new FakeRegistrar(7, "a copy").at("127.0.0.66", 4160);
  }

  @AfterEach
  void close() {
    directory.close();
  }

  private static RemoteModule server() {
    return (RemoteModule)
        Proxy.newProxyInstance(
            RemoteModule.class.getClassLoader(),
            new Class<?>[] {RemoteModule.class},
            (proxy, method, args) ->
                switch (method.getName()) {
                  case "equals" -> proxy == args[0];
                  case "hashCode" -> System.identityHashCode(proxy);
                  default -> throw new AssertionError(method + " is a call");
                });
  }

  private static ServiceItem item(RemoteModule server, String host) {
    ModuleAttributes attributes =
        new ModuleAttributes(
            "atrv1",
            "gps",
            "org.example.Driver",
            host,
            "DFRA",
            "1.0",
            Readiness.READY,
            VOUCHED,
            null,
            0);
    return new ServiceItem(
        ID, server == null ? null : new Gps(server), Entries.toEntries(List.of(attributes)));
  }

  private ServiceItem own() {
    return item(server, "127.0.0.1");
  }

  private ServiceItem fake() {
    return item(otherServer, "127.0.0.66");
  }

  private List<ModuleListing<Module>> listings() {
    return directory.find(ModuleQuery.of(Module.class));
  }

  private void assertShows(RemoteModule which, boolean isStale) {
    assertThat(listings())
        .singleElement()
        .satisfies(
            each -> {
              assertThat(((ModuleProxy<?>) each.module()).server() == which).isTrue();
              assertThat(each.stale()).isEqualTo(isStale);
            });
  }

  @Test
  void theFirstWithinReachCountsAndAnotherChangesNothing() {
    serviceTable.replaceAll(honest, List.of(own()));
    serviceTable.replaceAll(stranger, List.of(fake()));
    assertShows(server, false);
    serviceTable.update(stranger, fake());
    assertShows(server, false);
    serviceTable.remove(stranger, ServiceTable.uuid(ID));
    assertShows(server, false);
    serviceTable.update(stranger, fake());
    serviceTable.markOutOfReach(stranger, VOUCHED);
    assertShows(server, false);
  }

  @Test
  void theNextOneCountsWhenTheFirstIsOutOfReachOrLetsGo() {
    serviceTable.replaceAll(honest, List.of(own()));
    serviceTable.replaceAll(stranger, List.of(fake()));
    serviceTable.markOutOfReach(honest, VOUCHED);
    assertShows(otherServer, false);
    serviceTable.replaceAll(honest, List.of(own()));
    assertShows(otherServer, false);
    serviceTable.remove(stranger, ServiceTable.uuid(ID));
    assertShows(server, false);
    serviceTable.remove(honest, ServiceTable.uuid(ID));
    assertThat(listings()).isEmpty();
  }

  @Test
  void aStrangerThatGoesDoesNotRemoveWhatOneOutOfReachLists() {
    serviceTable.replaceAll(honest, List.of(own()));
    serviceTable.markOutOfReach(honest, VOUCHED);
    assertShows(server, true);
    serviceTable.replaceAll(stranger, List.of(fake()));
    serviceTable.replaceAll(stranger, List.of());
    assertShows(server, true);
    assertThat(listings().get(0).confirmed()).isEqualTo(VOUCHED);
    serviceTable.replaceAll(honest, List.of());
    assertThat(listings()).isEmpty();
  }

  @Test
  void aModuleThatLeavesOneWithinReachIsGoneThoughAnotherIsOutOfReach() {
    serviceTable.replaceAll(honest, List.of(own()));
    serviceTable.replaceAll(stranger, List.of(own()));
    serviceTable.markOutOfReach(honest, VOUCHED);
    serviceTable.remove(stranger, ServiceTable.uuid(ID));
    assertThat(listings()).isEmpty();
  }

  @Test
  void aProxyThatCannotBeReadHidesNoneThatCan() {
    ServiceItem unreadable = item(null, "127.0.0.66");
    serviceTable.replaceAll(stranger, List.of(unreadable));
    assertThat(serviceTable.unreadable()).hasSize(1);
    serviceTable.replaceAll(honest, List.of(own()));
    assertShows(server, false);
    assertThat(serviceTable.unreadable()).isEmpty();
    serviceTable.markOutOfReach(honest, VOUCHED);
    assertShows(server, true);
    assertThat(serviceTable.unreadable()).hasSize(1);
  }

  @Test
  void aConflictIsReportedWhileItLasts() {
    serviceTable.replaceAll(honest, List.of(own()));
    assertThat(serviceTable.conflicts()).isEmpty();
    serviceTable.replaceAll(stranger, List.of(fake()));
    assertThat(serviceTable.conflicts())
        .containsExactly(
            new ModuleConflict(
                "atrv1/gps",
                ServiceTable.uuid(ID).toString(),
                "127.0.0.1:4160",
                List.of("127.0.0.66:4160")));
    serviceTable.markOutOfReach(stranger, VOUCHED);
    assertThat(serviceTable.conflicts()).isEmpty();
  }

  @Test
  void oneModuleInTwoLookupServicesIsNoConflict() {
    serviceTable.replaceAll(honest, List.of(own()));
    serviceTable.replaceAll(stranger, List.of(own()));
    assertThat(serviceTable.conflicts()).isEmpty();
  }

  @Test
  void aRestartedLookupServiceTakesThePlaceOfItsFormerSelf() throws Exception {
    serviceTable.replaceAll(honest, List.of(own()));
    serviceTable.markOutOfReach(honest, VOUCHED);
    LocatedRegistrar restarted = new FakeRegistrar(7, "restarted").at("127.0.0.1", 4161);
    serviceTable.replaceAll(restarted, List.of());
    assertThat(listings()).isEmpty();
  }

  @Test
  void aRobotIsWhereItsOwnLookupServiceIsThoughACopyClaimsItToo() {
    UUID registrar = ServiceTable.uuid(honest.getServiceID());
    PersonaAttributes persona = new PersonaAttributes("atrv1", "scout", List.of(), List.of());
    ServiceItem robot =
        new ServiceItem(honest.getServiceID(), "a registrar", Entries.toEntries(List.of(persona)));
    serviceTable.setHost(honest, "192.0.2.1");
    serviceTable.replaceAll(honest, List.of(robot));
    serviceTable.setHost(stranger, "192.0.2.66");
    serviceTable.replaceAll(stranger, List.of(robot));
    assertThat(directory.personas()).extracting(Persona::host).containsExactly("192.0.2.1");
    serviceTable.remove(stranger, registrar);
    assertThat(directory.personas()).extracting(Persona::host).containsExactly("192.0.2.1");
  }
}
