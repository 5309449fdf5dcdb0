package org.dfra.river.filter;

import java.io.ObjectInputFilter;
import java.util.function.BinaryOperator;
import org.jspecify.annotations.Nullable;

/**
 * Gives every object stream of the virtual machine a filter (JEP 415).
 *
 * <p>What a stream reads from is not guessed: each has the network's limits, unless the thread that
 * makes it is {@linkplain SerialFilters#readStored reading what this computer stored}.
 *
 * <p>{@link SerialFilters#install()} puts it in place; a virtual machine whose main class is not
 * DFRA's gets it by {@code -Djdk.serialFilterFactory=org.dfra.river.filter.SerialFilterFactory}.
 */
public final class SerialFilterFactory implements BinaryOperator<@Nullable ObjectInputFilter> {

  /** The JDK asks for this constructor when it is named by system property. */
  public SerialFilterFactory() {}

  /**
   * @param current what the stream has, null while it is constructed
   * @param next the virtual machine's filter while it is constructed, else what its owner sets
   */
  @Override
  public ObjectInputFilter apply(
      @Nullable ObjectInputFilter current, @Nullable ObjectInputFilter next) {
    if (current == null) {
      ObjectGraphFilter ours = SerialFilters.newStreamFilter();
      return next == null ? ours : new Both(next, ours);
    }
    if (next == null) {
      return current;
    }
    if (next instanceof ObjectGraphFilter) { // a call's: stands in for the general one
      return current instanceof Both both ? new Both(both.theirs(), next) : next;
    }
    return new Both(next, current);
  }

  /** Refuses what one of two refuses; the owner's filter is asked first. */
  private record Both(ObjectInputFilter theirs, ObjectInputFilter ours)
      implements ObjectInputFilter {
    @Override
    public Status checkInput(FilterInfo info) {
      Status first = theirs.checkInput(info);
      if (first == Status.REJECTED) {
        return first;
      }
      Status second = ours.checkInput(info);
      return second == Status.UNDECIDED ? first : second;
    }
  }
}
