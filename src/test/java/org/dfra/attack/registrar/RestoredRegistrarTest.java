package org.dfra.attack.registrar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.jini.admin.DestroyAdmin;
import com.sun.jini.start.LifeCycle;
import com.sun.jini.start.ServiceProxyAccessor;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.net.ConnectException;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.lookup.entry.Name;
import org.dfra.attack.kit.AttackHosts;
import org.dfra.attack.kit.Fakes;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.attack.SourceSockets;
import org.dfra.core.host.FreePorts;
import org.dfra.directory.RegistrationRefusedException;
import org.dfra.river.entry.ModuleEntry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A registrar that was restarted from what it had written knows whose its registrations are. */
@Timeout(60)
class RestoredRegistrarTest {

  private static final ServiceID DRIVE = new ServiceID(0xd, 0xe);
  private static final ServiceID ANOTHER_ROBOTS = new ServiceID(0xa, 1);
  private static final ServiceID NOBODYS = new ServiceID(0xa, 2);
  private static final String CLASS = "com.sun.jini.reggie.PersistentRegistrarImpl";

  @TempDir Path folder;

  private final AttackHosts hosts = AttackHosts.assumed();

  /** The same for both, as reggie writes it down. */
  private int port;

  @Test
  void refusesAStolenServiceIdRightAfterItsStart() throws Exception {
    port = FreePorts.allocate();
    Path after = folder.resolve("after");
    try (Persistent first = new Persistent(folder.resolve("before"))) {
      Fakes.register(first.own(), DRIVE, "honest", Fakes.module("eta", "drive"));
      ModuleEntry ofAnother = Fakes.module("theta", "drive");
      ofAnother.host = hosts.operator();
      Fakes.register(first.from(hosts.operator()), ANOTHER_ROBOTS, "another robot's", ofAnother);
      Fakes.register(first.from(hosts.operator()), NOBODYS, "nobody's", new Name("x"));
      copy(folder.resolve("before"), after); // as kill -9 leaves it
    }
    try (Persistent second = new Persistent(after)) {
      assertThat(Fakes.proxy(second.own(), DRIVE)).contains("honest");
      ServiceRegistrar stranger = second.from(hosts.attacker());
      for (ServiceID each : List.of(DRIVE, ANOTHER_ROBOTS, NOBODYS)) {
        assertThatThrownBy(() -> Fakes.register(stranger, each, "fake"))
            .isInstanceOf(RegistrationRefusedException.class)
            .hasMessageContaining(each.toString());
      }
      Fakes.register(
          second.from(hosts.operator()), ANOTHER_ROBOTS, "again", Fakes.module("theta", "drive"));
      Fakes.register(second.own(), DRIVE, "new incarnation", Fakes.module("eta", "drive"));
      assertThat(Fakes.proxy(second.own(), DRIVE)).contains("new incarnation");
      assertThat(Fakes.proxy(second.own(), ANOTHER_ROBOTS)).contains("again");
    }
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      for (Path each : files.toList()) {
        Path unused = Files.copy(each, to.resolve(from.relativize(each).toString()));
      }
    }
  }

  /** Stock reggie that writes down what it knows, in this virtual machine. */
  private final class Persistent implements AutoCloseable {

    private static final Duration PATIENCE = Duration.ofSeconds(30);
    private static final long POLL_MILLIS = 100;

    private final CountDownLatch ended = new CountDownLatch(1);
    private final Object reggie;

    Persistent(Path state) throws Exception {
      Path configuration = Files.createTempFile(folder, "reggie", ".config");
      String unused =
          Files.writeString(
                  configuration,
                  """
                  import net.jini.jeri.BasicJeriExporter;
                  import org.dfra.river.registrar.DiscoveryServerSocketFactory;
                  import org.dfra.river.bootstrap.RegistrarExporter;
                  import org.dfra.river.call.Endpoints;
                  import org.dfra.river.registrar.RegistrarILFactory;

                  com.sun.jini.reggie {
                      serverExporter = new RegistrarExporter(
                          new BasicJeriExporter(
                              Endpoints.tcp("%1$s", 0),
                              new RegistrarILFactory(2000L, "eta", ""), false, true));
                      serverSocketFactory = new DiscoveryServerSocketFactory("%1$s");
                      unicastDiscoveryHost = "%1$s";
                      initialUnicastDiscoveryPort = %2$d;
                      initialMemberGroups = new String[]{};
                      persistenceDirectory = "%3$s";
                      multicastInterfaces = new java.net.NetworkInterface[]{};
                      unexportTimeout = 1000L;
                  }

                  net.jini.discovery.LookupDiscovery {
                      multicastInterfaces = new java.net.NetworkInterface[]{};
                  }
                  """
                      .formatted(hosts.robot(), port, state))
              .toString();
      Constructor<?> constructor =
          Class.forName(CLASS).getDeclaredConstructor(String[].class, LifeCycle.class);
      constructor.setAccessible(true);
      LifeCycle life =
          whose -> {
            ended.countDown();
            return true;
          };
      reggie = constructor.newInstance(new String[] {configuration.toString()}, life);
    }

    ServiceRegistrar own() throws IOException {
      return (ServiceRegistrar) ((ServiceProxyAccessor) reggie).getServiceProxy();
    }

    ServiceRegistrar from(String address) throws IOException {
      return SourceBoundProxies.of(own(), SourceSockets.from(address));
    }

    /** Reggie wakes its thread for connections at the computer's own name, which is not here. */
    @Override
    public void close() throws Exception {
      ((DestroyAdmin) reggie).destroy();
      long began = System.nanoTime();
      while (!ended.await(POLL_MILLIS, TimeUnit.MILLISECONDS)) {
        assertThat(Duration.ofNanos(System.nanoTime() - began)).isLessThan(PATIENCE);
        wake();
      }
    }

    private void wake() throws IOException {
      try (Socket socket = new Socket(hosts.robot(), port)) {
        assertThat(socket.isConnected()).isTrue();
      } catch (ConnectException e) {
        assertThat(e).as("it listens no more").hasMessageContaining("refused");
      }
    }
  }
}
