package org.dfra.cli.task;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behaviors.raster.Region;
import org.dfra.behaviors.raster.RegionFile;
import org.dfra.behaviors.raster.RegionParser;
import org.dfra.core.config.ConfigurationException;
import org.dfra.geometry.LocalPosition;

/**
 * A region as given on the command line.
 *
 * @param region the region
 * @param place prefix of error messages about it: its file, a colon and a blank; or empty
 */
public record GivenRegion(Region region, String place) {

  /** Example of corners on the command line. */
  public static final String EXAMPLE = "\"48.0001,11.0001 48.0001,11.0004 48.0002,11.0004\"";

  /** Starts like a number and has a comma: corners rather than the name of a missing file. */
  private static final Pattern CORNERS = Pattern.compile("\\s*([-+.;,0-9][^,]*,.*|[-+.;,0-9\\s]*)");

  /**
   * The region of a GeoJSON file, or of corners, latitude first.
   *
   * @param text a file's name, or pairs of numbers
   * @throws ConfigurationException if the file is invalid; the message names file and line
   * @throws GoalRefusedException if the corners are invalid
   */
  public static GivenRegion parse(String text) {
    if (!isFile(text) && CORNERS.matcher(text).matches()) {
      return new GivenRegion(RegionParser.parse(text), "");
    }
    try {
      Path file = Path.of(text);
      if (!Files.exists(file)) {
        throw new ConfigurationException(
            text
                + ": there is no such file; name a GeoJSON file, or write corners as in "
                + EXAMPLE);
      }
      return new GivenRegion(RegionFile.read(file), file + ": ");
    } catch (InvalidPathException e) {
      throw new ConfigurationException(
          "this is neither a file nor corners: \""
              + text.replace('\0', '?')
              + "\"; name a GeoJSON file, or write corners as in "
              + EXAMPLE,
          e);
    }
  }

  private static boolean isFile(String text) {
    try {
      return Files.isRegularFile(Path.of(text));
    } catch (InvalidPathException e) {
      return false;
    }
  }

  /**
   * Rejects lanes that are farther apart than the region is wide. Lanes run north, so the width is
   * from west to east.
   *
   * @param spacing from lane to lane, metres
   * @throws GoalRefusedException with the region's width
   */
  public void requireWider(double spacing) {
    List<LocalPosition> corners = region.corners().stream().map(region.frame()::toLocal).toList();
    double west = corners.stream().mapToDouble(LocalPosition::east).min().orElseThrow();
    double east = corners.stream().mapToDouble(LocalPosition::east).max().orElseThrow();
    if (spacing > east - west) {
      throw new GoalRefusedException(
          String.format(
              Locale.ROOT,
              "%slanes %.2f m apart are wider than the region, which is %.2f m from west to east;"
                  + " give a smaller --spacing or a larger --region",
              place,
              spacing,
              east - west));
    }
  }

  /** The same exception, prefixed with the location of the region's text. */
  public GoalRefusedException withLocation(GoalRefusedException refusal) {
    return place.isEmpty() ? refusal : new GoalRefusedException(place + refusal.getMessage());
  }
}
