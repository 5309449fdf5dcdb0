/**
 * The behaviour of {@code docs/how-to/write-a-behavior.md}: {@link
 * org.dfra.example.patrol.PatrolImpl}, and its test on a simulated robot.
 */
package org.dfra.example.patrol;
