package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.geometry.GeoPosition;

/**
 * A region written in one line: {@code 48.0001,11.0002 48.0003,11.0002 48.0003,11.0005}, pairs of
 * latitude and longitude in degrees, separated by spaces or semicolons.
 */
public final class RegionParser {

  private static final Pattern COMMA = Pattern.compile("\\s*,\\s*");
  private static final Pattern BETWEEN = Pattern.compile("[\\s;]+");
  private static final Pattern NUMBER = Pattern.compile("[-+]?([0-9]{1,5}(\\.[0-9]*)?|\\.[0-9]+)");

  private RegionParser() {}

  /**
   * Parses a region.
   *
   * @throws GoalRefusedException if it is invalid; the message names the corner and the error
   */
  public static Region parse(String text) {
    String pairs = BETWEEN.matcher(COMMA.matcher(text).replaceAll(",")).replaceAll(" ").strip();
    if (pairs.isEmpty()) {
      throw new GoalRefusedException(
          "the region is empty; write three corners or more, as in 48.0001,11.0002"
              + " 48.0003,11.0002 48.0003,11.0005");
    }
    List<GeoPosition> corners = new ArrayList<>();
    for (String pair : pairs.split(" ", -1)) {
      corners.add(corner(pair, corners.size() + 1));
    }
    return Region.of(corners);
  }

  private static GeoPosition corner(String pair, int number) {
    String[] both = pair.split(",", -1);
    String where = "corner " + number + " of the region, \"" + pair + "\", ";
    if (both.length != 2
        || !NUMBER.matcher(both[0]).matches()
        || !NUMBER.matcher(both[1]).matches()) {
      throw new GoalRefusedException(
          where + "is not a position; write latitude,longitude in degrees, as in 48.0001,11.0002");
    }
    double latitude = Double.parseDouble(both[0]);
    double longitude = Double.parseDouble(both[1]);
    if (Math.abs(latitude) > 90 && Math.abs(latitude) <= 180 && Math.abs(longitude) <= 90) {
      throw new GoalRefusedException(
          where
              + "has latitude and longitude swapped, since no latitude is "
              + both[0]
              + "°; write latitude,longitude");
    }
    try {
      return new GeoPosition(latitude, longitude, 0);
    } catch (IllegalArgumentException e) {
      throw new GoalRefusedException(where + "is not on the earth: " + e.getMessage());
    }
  }
}
