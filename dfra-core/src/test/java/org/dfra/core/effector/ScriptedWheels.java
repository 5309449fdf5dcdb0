package org.dfra.core.effector;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.dfra.core.config.Parameters;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.DriveAttributes;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/** Wheels that record the commands that they receive. */
final class ScriptedWheels extends DriveImpl {

  static final String PATH = "atrv1/wheels";

  /** {@code turn 0.5 -0.1}, {@code halt}, {@code brake true}; in order. */
  final List<String> commands = new CopyOnWriteArrayList<>();

  volatile @Nullable RuntimeException cycleFails;
  volatile @Nullable RuntimeException haltFails;

  /** Setting a velocity waits for it while it is not null. */
  volatile @Nullable CountDownLatch cycleHeldUp;

  /** A halt waits for it while it is not null. */
  volatile @Nullable CountDownLatch haltHeldUp;

  ScriptedWheels(Scheduler scheduler, Map<String, String> parameters) {
    this(scheduler, parameters, 0.15);
  }

  ScriptedWheels(Scheduler scheduler, Map<String, String> parameters, double braking) {
    this(scheduler, parameters, braking, StateStore.inMemory());
  }

  ScriptedWheels(
      Scheduler scheduler, Map<String, String> parameters, double braking, StateStore state) {
    super(
        new ModuleContext(
            "atrv1",
            "wheels",
            Parameters.of(PATH, parameters),
            InstantSource.fixed(Instant.EPOCH),
            state,
            LeaseTerms.DEFAULT,
            scheduler),
        "scripted wheels",
        "DFRA",
        "1",
        new DriveAttributes(1, 2, 0.78, 0.64),
        braking,
        List.of());
  }

  @Override
  protected void onStart() {
    transitionTo(Readiness.READY);
  }

  @Override
  protected void onClose() {
    commands.add("closed");
  }

  @Override
  protected void setVelocity(Velocity wanted) {
    commands.add("turn " + wanted.speed() + " " + wanted.yawRate());
    await(cycleHeldUp);
    fail(cycleFails);
  }

  @Override
  protected void halt() {
    commands.add("halt");
    await(haltHeldUp);
    fail(haltFails);
  }

  @Override
  protected void brake(boolean set) {
    commands.add("brake " + set);
  }

  private static void await(@Nullable CountDownLatch holder) {
    try {
      if (holder != null) {
        holder.await();
      }
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  private static void fail(@Nullable RuntimeException failure) {
    if (failure != null) {
      throw failure;
    }
  }

  /** Its controller was switched off and on. */
  void restart(boolean brakeSet) {
    transitionTo(Readiness.INITIALIZING, "its controller was switched off");
    deviceReset(brakeSet);
  }

  void serveAgain() {
    transitionTo(Readiness.READY);
  }

  void switched(boolean brakeSet) {
    brakeReported(brakeSet);
  }
}
