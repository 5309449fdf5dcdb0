/**
 * A user's own kind of module, in its five classes: what {@code
 * docs/how-to/test-with-embedded-reggie.md} shows.
 */
package org.dfra.example.thermometer;
