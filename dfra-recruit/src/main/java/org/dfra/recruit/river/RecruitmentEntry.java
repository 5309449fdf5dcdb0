package org.dfra.recruit.river;

import java.util.List;
import net.jini.entry.AbstractEntry;
import net.jini.lookup.entry.ServiceControlled;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.river.entry.Mirrors;
import org.jspecify.annotations.Nullable;

/**
 * As what a robot may be asked for help, see {@link RecruitmentAttributes}. Null is unknown, or any
 * value in a template.
 *
 * <p>It stands for itself instead of extending {@link org.dfra.river.entry.ModuleEntry}: a client
 * that lacks this class can read all else that the agent says of itself.
 */
@Mirrors(RecruitmentAttributes.class)
public class RecruitmentEntry extends AbstractEntry implements ServiceControlled {

  private static final long serialVersionUID = 1L;

  /** What it can observe, sorted. */
  public @Nullable List<String> percepts;

  /** How fast it comes, metres per second. */
  public @Nullable Double speed;

  /** How it decides. */
  public @Nullable String strategy;

  /** A helper that is late by this is replaced by another, seconds. */
  public @Nullable Double replaceAfter;

  /** So much earlier it turns back by itself where it is the helper, seconds. */
  public @Nullable Double margin;

  /** Why it answers no call, since somebody stopped it. */
  public @Nullable String holdReason;

  /** With every field null. */
  public RecruitmentEntry() {}
}
