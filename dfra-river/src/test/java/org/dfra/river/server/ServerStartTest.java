package org.dfra.river.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.rmi.MarshalledObject;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.river.proxy.LocalModuleRegistry;
import org.dfra.river.proxy.sensor.OdometryProxy;
import org.dfra.river.server.sensor.OdometryServer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A server is unknown to others until its constructor has returned and it is started. */
@Timeout(60)
class ServerStartTest {

  private static final AtomicInteger STARTED = new AtomicInteger();
  private static final AtomicInteger CLOSED = new AtomicInteger();

  /** A sensor that counts its starts. */
  public static class Counter extends SensorImpl implements OdometrySensor {
    public Counter(ModuleContext context) {
      super(context, "a counter", "DFRA", "1", List.of("Odometry"), List.of());
    }

    @Override
    protected void onStart() {
      STARTED.incrementAndGet();
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {
      CLOSED.incrementAndGet();
    }

    @Override
    public double updateRate() {
      return 1;
    }

    @Override
    public Odometry odometry() {
      throw new NotReadyException(path(), readiness(), "it counts nothing");
    }
  }

  /** A sensor that cannot be started. */
  public static final class Broken extends Counter {
    public Broken(ModuleContext context) {
      super(context);
    }

    @Override
    protected void onStart() {
      throw new IllegalStateException("no counter is connected");
    }
  }

  @BeforeEach
  void forget() {
    STARTED.set(0);
    CLOSED.set(0);
  }

  private static OdometryServer made(UUID id, Class<?> driver) throws Exception {
    return new OdometryServer(
        null,
        new MarshalledObject<>(
            new ModuleActivation(
                new ModuleDescription(
                    "atrv1",
                    "odometry",
                    OdometryServer.class.getName(),
                    OdometryProxy.class.getName(),
                    driver.getName(),
                    null,
                    false,
                    Parameters.of("atrv1/odometry", Map.of()),
                    SourceLocation.CODE),
                id,
                "127.0.0.1",
                List.of(),
                List.of())));
  }

  @Test
  void aServerThatIsNotStartedDoesNothingAndNobodyKnowsIt() throws Exception {
    UUID id = UUID.randomUUID();
    try (OdometryServer server = made(id, Counter.class)) {
      assertThat(STARTED).hasValue(0);
      assertThat(LocalModuleRegistry.contains(id)).isFalse();
      assertThatThrownBy(server::getProxy).hasMessage("the server is not started");

      server.start();
      assertThat(STARTED).hasValue(1);
      assertThat(LocalModuleRegistry.contains(id)).isTrue();
      assertThat(server.getProxy()).isNotNull();
      assertThat(server.getAdmin()).isNotNull();
    }
    assertThat(CLOSED).hasValue(1);
    assertThat(LocalModuleRegistry.contains(id)).isFalse();
  }

  @Test
  void aServerThatWasNeverStartedCanBeClosed() throws Exception {
    UUID id = UUID.randomUUID();
    made(id, Counter.class).close();
    assertThat(STARTED).hasValue(0);
    assertThat(LocalModuleRegistry.contains(id)).isFalse();
  }

  @Test
  void aServerThatCannotBeStartedIsClosed() throws Exception {
    UUID id = UUID.randomUUID();
    OdometryServer server = made(id, Broken.class);
    assertThatThrownBy(server::start)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("no counter is connected");
    assertThat(CLOSED).hasValue(1);
    assertThat(LocalModuleRegistry.contains(id)).isFalse();
  }
}
