package org.dfra.river.filter;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The kinds of proxies in one stream and in the marshalled objects in it. For each combination of
 * interfaces, the virtual machine that reads the stream defines a class.
 */
final class ProxyKinds {

  /** The limit of combinations; a list of all modules of a team has a few dozen. */
  static final int MAX = 256;

  private final Set<List<String>> kinds = new HashSet<>();

  /**
   * Counts a proxy.
   *
   * @param interfaces their names in their order
   * @throws RefusedDataException if there are too many kinds
   */
  void count(List<String> interfaces) {
    if (kinds.add(interfaces) && kinds.size() > MAX) {
      throw new RefusedDataException(
          "refused to read on: more than "
              + MAX
              + " kinds of proxies; send objects with fewer combinations of interfaces");
    }
  }
}
