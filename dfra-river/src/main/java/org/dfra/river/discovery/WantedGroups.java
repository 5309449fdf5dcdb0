package org.dfra.river.discovery;

import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** The groups that a {@link MulticastSearch} searches for, whose shared search guards this. */
final class WantedGroups {

  private @Nullable Set<String> names; // null for all

  /**
   * @param names none of them null; null for all groups
   */
  WantedGroups(String @Nullable [] names) {
    this.names = names == null ? null : new HashSet<>(List.of(names));
  }

  /** The names, without duplicates; null for all. */
  String @Nullable [] names() {
    return names == null ? null : names.toArray(String[]::new);
  }

  /** Whether one of these groups is wanted. */
  boolean matchesAny(Collection<String> groups) {
    Set<String> wanted = names;
    return wanted == null || groups.stream().anyMatch(wanted::contains);
  }

  /**
   * Adds groups.
   *
   * @return those that were not wanted before
   * @throws UnsupportedOperationException if all are wanted
   */
  List<String> add(String[] more) {
    Set<String> all = some();
    Set<String> added = new HashSet<>(List.of(more));
    added.removeAll(all);
    all.addAll(added);
    return List.copyOf(added);
  }

  /**
   * Replaces all of them.
   *
   * @param wanted null for all
   * @return those that were not wanted before, an empty list for all groups; nothing if there are
   *     none
   */
  Optional<List<String>> set(String @Nullable [] wanted) {
    Set<String> before = names;
    if (wanted == null) {
      names = null;
      return before == null ? Optional.empty() : Optional.of(List.of());
    }
    Set<String> added = new HashSet<>(List.of(wanted));
    if (before != null) {
      added.removeAll(before);
    }
    names = new HashSet<>(List.of(wanted));
    return added.isEmpty() ? Optional.empty() : Optional.of(List.copyOf(added));
  }

  /**
   * Removes groups.
   *
   * @throws UnsupportedOperationException if all are wanted
   */
  void remove(String[] unwanted) {
    some().removeAll(List.of(unwanted));
  }

  private Set<String> some() {
    Set<String> some = names;
    if (some == null) {
      throw new UnsupportedOperationException(
          "all groups are searched for; set the groups that are wanted instead");
    }
    return some;
  }
}
