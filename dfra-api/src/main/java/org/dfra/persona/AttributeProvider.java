package org.dfra.persona;

import java.util.List;

/**
 * A module that says more of itself than what any server knows of it: what kind of sensor it is,
 * where it is mounted, which device it found.
 */
public interface AttributeProvider {

  /**
   * The attributes as they are now; one record of a type at most. Asked several times a second, so
   * it answers from memory, never from the device.
   */
  List<Attributes> attributes();
}
