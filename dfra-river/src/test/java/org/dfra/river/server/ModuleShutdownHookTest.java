package org.dfra.river.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.rmi.MarshalledObject;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.effector.DriveImpl;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.DriveAttributes;
import org.dfra.river.proxy.effector.DriveProxy;
import org.dfra.river.proxy.sensor.OdometryProxy;
import org.dfra.river.server.effector.DriveServer;
import org.dfra.river.server.sensor.OdometryServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** At the end of a process its effectors are closed first, and every module is closed. */
@Timeout(120)
class ModuleShutdownHookTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final List<String> CLOSED = new CopyOnWriteArrayList<>();

  /** A drive called {@code stuck} waits for it before it is closed. */
  private static volatile CountDownLatch release;

  /** An effector that writes down when it was closed. */
  public static final class Wheels extends DriveImpl {
    public Wheels(ModuleContext context) {
      super(context, "wheels", "DFRA", "1", new DriveAttributes(1, 2, 1, 1), 0, List.of());
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {
      if (path().equals("atrv1/stuck")) {
        try {
          release.await();
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
        }
      }
      CLOSED.add(path());
    }

    @Override
    protected void setVelocity(Velocity wanted) {}

    @Override
    protected void halt() {}

    @Override
    protected void brake(boolean set) {}
  }

  /** A sensor that writes down when it was closed. */
  public static final class Counter extends SensorImpl implements OdometrySensor {
    public Counter(ModuleContext context) {
      super(context, "a counter", "DFRA", "1", List.of("Odometry"), List.of());
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {
      CLOSED.add(path());
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

  @BeforeEach
  void forget() {
    CLOSED.clear();
    release = new CountDownLatch(1);
  }

  @AfterEach
  void release() {
    release.countDown();
  }

  private static MarshalledObject<ModuleActivation> data(
      String name, Class<?> server, Class<?> proxy, Class<?> driver) throws Exception {
    return new MarshalledObject<>(
        new ModuleActivation(
            new ModuleDescription(
                "atrv1",
                name,
                server.getName(),
                proxy.getName(),
                driver.getName(),
                null,
                false,
                Parameters.of("atrv1/" + name, Map.of()),
                SourceLocation.CODE),
            UUID.randomUUID(),
            "127.0.0.1",
            List.of(),
            List.of()));
  }

  private static DriveServer drive(String name) throws Exception {
    return ModuleServer.started(
        new DriveServer(null, data(name, DriveServer.class, DriveProxy.class, Wheels.class)));
  }

  private static OdometryServer counter(String name) throws Exception {
    return ModuleServer.started(
        new OdometryServer(
            null, data(name, OdometryServer.class, OdometryProxy.class, Counter.class)));
  }

  @Test
  void effectorsAreClosedBeforeAnythingElseOfTheProcess() throws Exception {
    List<ModuleServer<?>> servers =
        List.of(counter("c1"), drive("d1"), counter("c2"), drive("d2"), counter("c3"));
    ModuleShutdownHook.shutDownAll(servers);
    assertThat(CLOSED)
        .containsExactlyInAnyOrder("atrv1/c1", "atrv1/d1", "atrv1/c2", "atrv1/d2", "atrv1/c3");
    assertThat(CLOSED.subList(0, 2)).containsExactlyInAnyOrder("atrv1/d1", "atrv1/d2");
  }

  @Test
  void aDriverThatIsHeldUpKeepsNoOtherModuleFromItsEnd() throws Exception {
    List<ModuleServer<?>> servers = List.of(drive("stuck"), counter("c1"), drive("d1"));
    Thread ending = new Thread(() -> ModuleShutdownHook.shutDownAll(servers), "ending");
    ending.start();
    await()
        .atMost(PATIENCE)
        .untilAsserted(() -> assertThat(CLOSED).containsExactly("atrv1/d1", "atrv1/c1"));
    assertThat(ending.isAlive()).as("the process waits for the third").isTrue();
    release.countDown();
    ending.join();
    assertThat(CLOSED).containsExactly("atrv1/d1", "atrv1/c1", "atrv1/stuck");
  }
}
