package org.dfra.recruit.river;

import java.util.List;
import net.jini.entry.AbstractEntry;
import net.jini.lookup.entry.ServiceControlled;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.river.entry.Mirrors;
import org.jspecify.annotations.Nullable;

/**
 * A robot's properties for recruitment, see {@link RecruitmentAttributes}. Null means unknown, or
 * any value in a template.
 *
 * <p>It is independent instead of extending {@link org.dfra.river.entry.ModuleEntry}: a client that
 * lacks this class can read all other entries of the agent.
 */
@Mirrors(RecruitmentAttributes.class)
public class RecruitmentEntry extends AbstractEntry implements ServiceControlled {

  private static final long serialVersionUID = 1L;

  /** The percepts that it can observe, sorted. */
  public @Nullable List<String> percepts;

  /** Its travel speed, metres per second. */
  public @Nullable Double speed;

  /** Its strategy. */
  public @Nullable String strategy;

  /** A helper that is late by this is replaced by another, seconds. */
  public @Nullable Double replaceAfter;

  /** As helper it withdraws this much earlier, seconds. */
  public @Nullable Double margin;

  /** The reason of its hold after a stop; it then answers no call. */
  public @Nullable String holdReason;

  /** Creates an entry with all fields null. */
  public RecruitmentEntry() {}
}
