package org.dfra.persona;

import java.util.List;

/**
 * A module that provides attributes beyond those its server fills in: its kind of sensor, its
 * mounting pose, the detected device.
 */
public interface AttributeProvider {

  /**
   * The current attributes; at most one record of each type. Called several times a second, so it
   * returns cached values and never queries the device.
   */
  List<Attributes> attributes();
}
