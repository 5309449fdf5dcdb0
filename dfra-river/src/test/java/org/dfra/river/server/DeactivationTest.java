package org.dfra.river.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.effector.DriveImpl;
import org.dfra.core.module.ModuleContext;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.DriveAttributes;
import org.dfra.river.proxy.effector.DriveProxy;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.river.server.effector.DriveServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A module has ended only when its driver is closed, however many callers ask. */
@Timeout(120)
class DeactivationTest {

  /** Ample for a second call to return, where it does not wait. */
  private static final Duration AT_ONCE = Duration.ofSeconds(1);

  private static final long LONG_SECONDS = 60;

  private static volatile CountDownLatch closing;
  private static volatile CountDownLatch release;
  private static volatile boolean isClosed;
  private static volatile boolean fails;

  private final ExecutorService threads = Executors.newCachedThreadPool();
  private DriveServer server;
  private ModuleAdmin admin;

  /** Wheels whose end takes until the test releases it. */
  public static final class SlowWheels extends DriveImpl {
    public SlowWheels(ModuleContext context) {
      super(context, "wheels", "DFRA", "1", new DriveAttributes(1, 2, 1, 1), 0, List.of());
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {
      closing.countDown();
      try {
        release.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      if (fails) {
        throw new IllegalStateException("the port hangs");
      }
      isClosed = true;
    }

    @Override
    protected void setVelocity(Velocity wanted) {}

    @Override
    protected void halt() {}

    @Override
    protected void brake(boolean set) {}
  }

  @BeforeEach
  void serve() throws Exception {
    closing = new CountDownLatch(1);
    release = new CountDownLatch(1);
    isClosed = false;
    fails = false;
    ModuleDescription drive =
        new ModuleDescription(
            "atrv1",
            "drive",
            DriveServer.class.getName(),
            DriveProxy.class.getName(),
            SlowWheels.class.getName(),
            null,
            false,
            Parameters.of("atrv1/drive", Map.of()),
            SourceLocation.CODE);
    server =
        ModuleServer.started(
            new DriveServer(
                null,
                new MarshalledObject<>(
                    new ModuleActivation(
                        drive, UUID.randomUUID(), "127.0.0.1", List.of(), List.of()))));
    admin = (ModuleAdmin) server.getAdmin();
  }

  @AfterEach
  void end() {
    release.countDown();
    try {
      server.close();
    } catch (IllegalStateException e) {
      assertThat(fails).as("only where its driver is to fail: %s", e.getMessage()).isTrue();
    }
    threads.shutdownNow();
  }

  /** Asks the module to end; the answer says whether its driver was closed when it came. */
  private CompletableFuture<Boolean> deactivated() {
    CompletableFuture<Boolean> answer = new CompletableFuture<>();
    threads.execute(
        () -> {
          try {
            admin.deactivate();
            answer.complete(isClosed);
          } catch (RemoteException e) {
            answer.completeExceptionally(e);
          }
        });
    return answer;
  }

  private static void assertIsAwaited(CompletableFuture<Boolean> answer) {
    assertThatThrownBy(() -> answer.get(AT_ONCE.toMillis(), TimeUnit.MILLISECONDS))
        .as("an answer while the driver is being closed")
        .isInstanceOf(TimeoutException.class);
  }

  @Test
  void aSecondCallIsAnsweredWhenTheFirstHasClosedTheDriver() throws Exception {
    CompletableFuture<Boolean> first = deactivated();
    closing.await();
    CompletableFuture<Boolean> second = deactivated();
    assertIsAwaited(second);
    release.countDown();
    assertThat(first.get(LONG_SECONDS, TimeUnit.SECONDS)).isTrue();
    assertThat(second.get(LONG_SECONDS, TimeUnit.SECONDS)).isTrue();
  }

  @Test
  void aCallIsAnsweredWhenTheEndOfTheProcessHasClosedTheDriver() throws Exception {
    threads.execute(server::halt);
    closing.await();
    CompletableFuture<Boolean> answer = deactivated();
    assertIsAwaited(answer);
    release.countDown();
    assertThat(answer.get(LONG_SECONDS, TimeUnit.SECONDS)).isTrue();
  }

  @Test
  void everyoneLearnsThatTheDriverDidNotEndCleanly() throws Exception {
    fails = true;
    CompletableFuture<Boolean> first = deactivated();
    closing.await();
    CompletableFuture<Boolean> second = deactivated();
    assertIsAwaited(second);
    release.countDown();
    for (CompletableFuture<Boolean> each : List.of(first, second)) {
      assertThatThrownBy(() -> each.get(LONG_SECONDS, TimeUnit.SECONDS))
          .hasStackTraceContaining("the port hangs");
    }
  }

  @Test
  void closingTheServerDoesNotWaitForADriverThatAnotherThreadCloses() throws Exception {
    threads.execute(server::halt);
    closing.await();
    server.close(); // returns, or the module would stay in the lookup services
    assertThat(isClosed).isFalse();
  }
}
