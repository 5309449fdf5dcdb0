package org.dfra.app.raster;

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
 * A region as an operator gives it on the command line.
 *
 * @param region what is to be searched
 * @param place what complaints about it begin with: its file, a colon and a blank; or nothing
 */
public record GivenRegion(Region region, String place) {

  /** How corners look that are written on the command line. */
  public static final String EXAMPLE = "\"48.0001,11.0001 48.0001,11.0004 48.0002,11.0004\"";

  /** Begins as a number, and has a comma: corners rather than a file that is not there. */
  private static final Pattern CORNERS = Pattern.compile("\\s*([-+.;,0-9][^,]*,.*|[-+.;,0-9\\s]*)");

  /**
   * The region of a GeoJSON file, or that of corners, latitude first.
   *
   * @param text a file's name, or pairs of numbers
   * @throws ConfigurationException if the file is not what it should be; file and line are named
   * @throws GoalRefusedException if the corners are not
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
          "this is no file and these are no corners: \""
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
   * Refuses lanes that are farther apart than the region is wide. They run north: what counts is
   * how far the region reaches from west to east.
   *
   * @param spacing from lane to lane, metres
   * @throws GoalRefusedException saying how wide it is
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

  /** The same complaint, beginning with where the region is written. */
  public GoalRefusedException withLocation(GoalRefusedException refusal) {
    return place.isEmpty() ? refusal : new GoalRefusedException(place + refusal.getMessage());
  }
}
