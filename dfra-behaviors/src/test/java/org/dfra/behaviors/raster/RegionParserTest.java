package org.dfra.behaviors.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.dfra.behavior.GoalRefusedException;
import org.dfra.geometry.GeoPosition;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RegionParserTest {

  @ParameterizedTest
  @ValueSource(
      strings = {
        "48.0001,11.0002 48.0003,11.0002 48.0003,11.0005",
        "48.0001,11.0002;48.0003,11.0002;48.0003,11.0005;",
        " 48.0001, 11.0002 ; 48.0003 ,11.0002\n+48.0003,11.0005 48.0001,11.0002 "
      })
  void readsPairsOfLatitudeAndLongitude(String text) {
    assertThat(RegionParser.parse(text).corners())
        .containsExactly(
            new GeoPosition(48.0001, 11.0002, 0),
            new GeoPosition(48.0003, 11.0002, 0),
            new GeoPosition(48.0003, 11.0005, 0));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "' ; '|the region is empty; write three corners or more, as in 48.0001,11.0002"
            + " 48.0003,11.0002 48.0003,11.0005",
        "48,11 48.1 48.2,11|corner 2 of the region, \"48.1\", is not a position; write"
            + " latitude,longitude in degrees, as in 48.0001,11.0002",
        "48,11,510|corner 1 of the region, \"48,11,510\", is not a position; write"
            + " latitude,longitude in degrees, as in 48.0001,11.0002",
        "48,11 NaN,11|corner 2 of the region, \"NaN,11\", is not a position; write"
            + " latitude,longitude in degrees, as in 48.0001,11.0002",
        "151.2,-33.8|corner 1 of the region, \"151.2,-33.8\", has latitude and longitude swapped,"
            + " since no latitude is 151.2°; write latitude,longitude",
        "-33.8,451.2|corner 1 of the region, \"-33.8,451.2\", is not on the earth: longitude"
            + " 451.2° is outside −180° to 180°",
        "480,110|corner 1 of the region, \"480,110\", is not on the earth: latitude 480.0° is"
            + " outside −90° to 90°",
        "48,11 48.0001,11|a region of 2 different corners encloses nothing; give three or more"
      })
  void saysWhatIsNoRegion(String text, String message) {
    assertThatThrownBy(() -> RegionParser.parse(text))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessage(message);
  }
}
