package org.dfra.security;

import java.util.Set;

/**
 * What a caller sees of the services that a lookup service lists. What it does not see is for it as
 * if it were not registered. Thread-safe; it must not wait.
 */
public interface Visibility {

  /** Of a caller from whom nothing is hidden. */
  Visibility ALL = new CompleteVisibility();

  /**
   * A service that a lookup service lists.
   *
   * @param robot the robot that its entries name; empty if they name none
   * @param object name of the module that its entries name; empty if they name none
   * @param types full names of all its types, also of the inherited ones
   */
  record ListedService(String robot, String object, Set<String> types) {

    /** Copies the set. */
    public ListedService {
      types = Set.copyOf(types);
    }
  }

  /** What a caller sees of one service. */
  interface OfService {

    /** Whether it sees that the service exists, with its types and its proxy. */
    boolean isShown();

    /**
     * Whether it sees an attribute.
     *
     * @param type full name of the attribute record, or of an entry class that mirrors none
     * @param component name of the record's component, or of the entry's field
     */
    boolean isShown(String type, String component);

    /**
     * Whether it sees all attributes of a record or of an entry whose components are not known.
     *
     * @param type full name of the attribute record, or of an entry class that mirrors none
     */
    boolean isShown(String type);
  }

  /** Whether it is known without a look at any service that nothing is hidden. */
  boolean isComplete();

  /** What the caller sees of a service. */
  OfService of(ListedService service);
}
