package org.dfra.recruit.agent;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputFilter;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.BootId;
import org.dfra.core.time.ScaledTime;

/**
 * Keeps what of an agent outlives its process.
 *
 * <p>It is written, and brought to the disk, within the turn in which it changed, before anything
 * that follows from it is sent: whoever gets a letter can rely on that its sender still knows what
 * it said. So a slow disk holds up the agent's next turn, and with it others' letters to it, by as
 * long as a write takes, milliseconds; a state changes some ten times for a call. Written outside
 * of the turn, the letters of several turns would have to wait for their writes in order, and what
 * waits would be lost where the module ends. {@link Recruiter#status} does not wait.
 *
 * <p>The times of a snapshot go by the agent's {@link #clock}, which nobody sets. With it are kept
 * the boot ID and the time since boot, so the clock goes on in the next process from where it was,
 * whatever the computer's clock says by then. What was kept in another boot, or by another
 * simulated time, is recalled {@linkplain AgentSnapshot#afterAnotherBoot without its spans}. So it
 * is where the operating system names no boots.
 */
final class AgentMemory {

  private static final String DOCUMENT = "recruitment";

  /** What a snapshot is made of, and no more: the file may have been tampered with. */
  private static final ObjectInputFilter SNAPSHOTS =
      ObjectInputFilter.Config.createFilter(
          "org.dfra.agent.*;org.dfra.geometry.*;org.dfra.recruit.**;java.lang.*;java.time.*;"
              + "java.util.*;maxdepth=20;maxarray=100000;!*");

  /**
   * As it is written down.
   *
   * @param origin names the boot and the time that both others go by; empty where nobody knows
   * @param sinceBoot nanoseconds of the robot's time
   * @param time by the agent's clock, then
   */
  private record Kept(String origin, long sinceBoot, Instant time, AgentSnapshot snapshot)
      implements Serializable {}

  /** What was kept is there, and nothing can be made of it. */
  static final class DamagedException extends IOException {

    private static final long serialVersionUID = 1;

    private DamagedException(String message, Exception cause) {
      super(message, cause);
    }
  }

  private final ModuleContext context;
  private final StateStore state;
  private final BootId boot;
  private SteadyClock clock; // another one only by recall, before anybody else goes by it

  AgentMemory(ModuleContext context, BootId boot) {
    this.context = context;
    this.state = context.state();
    this.boot = boot;
    this.clock = new SteadyClock(context.clock().instant(), context.robotTime());
  }

  /** What every span of the agent goes by: after {@link #load}, as its last process had it. */
  InstantSource clock() {
    return clock;
  }

  /** Which time it is that {@link #sinceBoot} counts; empty where nobody can tell it again. */
  private String origin() throws IOException {
    String scaled = context.clock() instanceof ScaledTime time ? ", " + time : "";
    return boot.read().map(id -> id + scaled).orElse("");
  }

  /**
   * The robot's time in nanoseconds, from an origin that is the same in each process of this boot.
   * A scaled time's own origin is not, where the computer's clock was set between two of them.
   */
  private long sinceBoot() {
    return context.clock() instanceof ScaledTime time
        ? (long) (context.scheduler().nanos() * time.speed())
        : context.robotTime().nanos();
  }

  /**
   * @throws IOException if it cannot be written; then what was kept before is kept
   */
  void save(AgentSnapshot snapshot) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(new Kept(origin(), sinceBoot(), clock.instant(), snapshot));
    }
    state.write(DOCUMENT, bytes.toByteArray());
  }

  /**
   * What was kept. The agent's clock goes on from there.
   *
   * @throws IOException if it cannot be read, or is something else, or if it is not known in which
   *     boot this is; then {@link #loadWithoutTimers} may know some of it
   */
  Optional<AgentSnapshot> load() throws IOException {
    Optional<Kept> kept = read();
    return kept.isEmpty() ? Optional.empty() : Optional.of(goOn(kept.get()));
  }

  /**
   * What must not be repeated of what was kept, as {@linkplain AgentSnapshot#afterAnotherBoot after
   * another boot}: where nobody knows whether this is another.
   *
   * @throws DamagedException if it is something else; the message names the file
   * @throws IOException if it cannot be read; likewise
   */
  Optional<AgentSnapshot> loadWithoutTimers() throws IOException {
    return read().map(this::withoutSpans);
  }

  private Optional<Kept> read() throws IOException {
    String what = "what it kept of its conversations in " + state + "/" + DOCUMENT;
    Optional<byte[]> kept;
    try {
      kept = state.read(DOCUMENT);
    } catch (IOException e) { // of the disk, or for want of descriptors
      throw new IOException(what + " cannot be read: " + e, e);
    }
    try {
      return kept.isEmpty() ? Optional.empty() : Optional.of(read(kept.get()));
    } catch (IOException | ClassNotFoundException | RuntimeException e) {
      throw new DamagedException(what + " cannot be understood: " + e, e);
    }
  }

  private Kept read(byte[] kept) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(kept))) {
      in.setObjectInputFilter(SNAPSHOTS);
      Object found = in.readObject();
      if (found instanceof Kept last) {
        return last;
      }
      if (found instanceof AgentSnapshot snapshot) { // of an earlier version, by the wall clock
        return new Kept("", 0, context.clock().instant(), snapshot);
      }
      throw new InvalidObjectException("it is something else");
    }
  }

  private AgentSnapshot goOn(Kept last) throws IOException {
    long passed = sinceBoot() - last.sinceBoot();
    boolean isSameTime = !last.origin().isEmpty() && last.origin().equals(origin()) && passed >= 0;
    if (!isSameTime) {
      return withoutSpans(last);
    }
    clock = new SteadyClock(last.time().plusNanos(passed), context.robotTime());
    return last.snapshot();
  }

  private AgentSnapshot withoutSpans(Kept last) {
    Instant wall = context.clock().instant();
    Instant now = wall.isAfter(last.time()) ? wall : last.time(); // letters' numbers go by it
    clock = new SteadyClock(now, context.robotTime());
    return last.snapshot().afterAnotherBoot();
  }
}
