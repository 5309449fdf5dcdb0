package org.dfra.river.contract;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.dfra.core.effector.DriveImpl;
import org.dfra.core.module.ModuleContext;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.DriveAttributes;
import org.jspecify.annotations.Nullable;

/** A drive that records its commands. The command timeout acts when the test says so. */
public final class ScriptedDrive extends DriveImpl {

  private static final Map<String, ScriptedDrive> LAST = new ConcurrentHashMap<>();

  /** {@code turn 0.5 -0.1}, {@code halt}, {@code brake true}, {@code closed}; in order. */
  final List<String> commands = new CopyOnWriteArrayList<>();

  /** Setting a velocity waits for it while it is not null. */
  volatile @Nullable CountDownLatch cycleHeldUp;

  private final HeldScheduler scheduler;

  public ScriptedDrive(ModuleContext context) {
    this(context, new HeldScheduler());
  }

  private ScriptedDrive(ModuleContext context, HeldScheduler scheduler) {
    super(
        new ModuleContext(
            context.robot(),
            context.name(),
            context.parameters(),
            context.clock(),
            context.state(),
            context.leases(),
            scheduler),
        "a scripted drive",
        "DFRA",
        "1",
        new DriveAttributes(1, 2, 0.78, 0.64),
        0.15,
        List.of());
    this.scheduler = scheduler;
    LAST.put(context.path(), this);
  }

  /** The one that was made last under this path. */
  static ScriptedDrive last(String path) {
    return LAST.get(path);
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
    CountDownLatch holder = cycleHeldUp;
    try {
      if (holder != null) {
        holder.await();
      }
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  protected void halt() {
    commands.add("halt");
  }

  @Override
  protected void brake(boolean set) {
    commands.add("brake " + set);
  }

  /** If no velocity has come for too long by now, the drive may notice. */
  void look() {
    scheduler.release();
  }

  void lose() {
    transitionTo(Readiness.INITIALIZING, "its cable was cut");
    deviceReset(false);
  }
}
